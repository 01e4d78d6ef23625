#include "client_server/predicted_game.h"

#include <algorithm>

#include "base/check.h"

namespace temblor::test {
namespace {

const platform::Address kServer = platform::ip4_address({10, 0, 0, 1}, 26000);
const platform::Address kClient = platform::ip4_address({10, 0, 0, 2}, 4000);

}  // namespace

PredictedGame::PredictedGame(const std::filesystem::path& data, const std::string& map,
                             const NetworkConditions& conditions, std::uint64_t seed)
    : library_(std::make_unique<assets::Library>(vfs::FileSystem::open(data).value())),
      settings_(std::make_unique<server::ServerVariables>(variables_)),
      network_(conditions, seed),
      client_(network_.open(kClient), client::PlayerSettings{"walker"}) {
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(network_.open(kServer));
  server_ = std::make_unique<server::Server>(
      server::ServerSetup{.library = *library_,
                          .settings = *settings_,
                          .sockets = std::move(sockets),
                          .max_clients = 1,
                          .program_file = TEMBLOR_GAME_PROGRAM,
                          .print = [this](std::string_view text) { console_ += text; },
                          .seed = seed});
  const base::Status started = server::start_map(*server_, map);
  CHECK(started.ok(), "{}", started.error().message());
  level_ = library_->level("maps/" + map + ".bsp").value().level;
  client_.connect(kServer, now_s_);
}

bool PredictedGame::join() {
  for (int i = 0; i < 2000 && !shown_; ++i) frame({});
  if (!shown_) return false;
  player().set_flag(server::flag::kGodMode);
  run(3);  // some packets arrive late
  remove_monsters();
  run(0.5);
  return true;
}

void PredictedGame::remove_monsters() {
  server::GameWorld& world = game().world();
  for (std::uint32_t i = 2; i < world.edicts.count(); ++i) {
    const vm::EntityIndex index{i};
    if (!world.edicts.is_free(index) && world.edicts[index].has_flag(server::flag::kMonster))
      server::remove(world, index);
  }
}

void PredictedGame::frame(const net::Move& doing) {
  now_s_ += frame_s;
  network_.advance_to(now_s_);
  for (int due = client_.count_due_moves(now_s_); due > 0; --due) {
    client_.send_move(doing);
    ++moves_sent_;
  }
  server::step_server(*server_, now_s_);
  client_.update(now_s_);
  client::ClientState& state = client_.state();
  if (!client_.is_playing()) return;
  drawn_time_s_ = std::clamp(drawn_time_s_ + frame_s, state.previous_time_s(), state.time_s());
  const std::span<const client::InterpolatedEntity> seen = state.interpolate_entities(drawn_time_s_, {});
  drawn_.assign(seen.begin(), seen.end());
  prediction_.begin_frame(client_, doing, now_s_);
  shown_ = prediction_.advance(state, *level_, drawn_);
  state.events().clear();
}

void PredictedGame::run(double seconds, const net::Move& doing) {
  for (const double until_s = now_s_ + seconds; now_s_ < until_s;) frame(doing);
}

void PredictedGame::put_player(const math::Vec3& origin) {
  player().set(server::field::kOrigin, origin);
  player().set(server::field::kVelocity, math::Vec3(0.0f));
  const base::Status linked =
      server::link(server_->game->world(), player().index(), server::TouchTriggers::kNo);
  CHECK(linked.ok());
  run(1);
}

}  // namespace temblor::test
