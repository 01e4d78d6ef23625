#include "app/level/running_level.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "base/text.h"
#include "net/protocol/message_reader.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

// Monsters and items have come to rest after a second.
constexpr double kPlayed_s = 1, kMaxJoin_s = 10;
constexpr const char* kProgram = "progs.dat";

// Returns an error with advice if no game directory has game code.
base::Status check_game_code(const LoadedMap& loaded, const std::filesystem::path& program) {
  if (!loaded.library)
    return base::error(ErrorCode::kNotFound,
                       "--entities needs the game's code, {}, and there is no game data; name the directory "
                       "that contains id1 with --basedir, or leave out --entities",
                       kProgram);
  const vfs::FileSystem& files = loaded.library->files();
  if (!program.empty() || files.contains(kProgram)) return base::Ok{};
  std::vector<std::string> searched;
  for (const std::filesystem::path& folder : files.folders()) searched.push_back(folder.string());
  return base::error(
      ErrorCode::kNotFound,
      "--entities needs the game's code, and there is no {} in {}; name the file with --progs, or "
      "the game that has it with --basedir or --game, or leave out --entities",
      kProgram, fmt::join(searched, " or "));
}

// How the server begins the line about game code that failed.
constexpr std::string_view kFailure = "game code failed: ";

// The line in which the first `part` is; empty if there is none.
std::string find_line(std::string_view text, std::string_view part) {
  const std::size_t at = text.find(part);
  if (at == std::string_view::npos) return {};
  text.remove_prefix(at);
  return base::printable(text.substr(0, text.find('\n')));
}

}  // namespace

// start() has checked that there is a library. Nothing is written, because the server gets no folder.
RunningLevel::RunningLevel(const LoadedMap& loaded, const std::filesystem::path& program,
                           const server::ServerVariables& rules,
                           const client::PresentationSettings& presentation)
    : loaded_(loaded),
      settings_(presentation),
      connection_(network_.open(), client::PlayerSettings{}),
      presentation_(*loaded.library) {
  presentation_.set_prediction(&prediction_);
  settings_.show_weapon = false;
  settings_.sound = false;
  settings_.camera.reset();
  settings_.choices.chase.reset();
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(network_.open());
  server_ = std::make_unique<server::Server>(
      server::ServerSetup{.library = *loaded.library,
                          .settings = rules,
                          .sockets = std::move(sockets),
                          .max_clients = 1,
                          .oldest_protocol = net::Protocol::kRmq,
                          .program_file = program,
                          .print = [this](std::string_view text) { console_ += text; },
                          .prints_events = false});
}

base::Result<std::unique_ptr<RunningLevel>> RunningLevel::start(
    const LoadedMap& loaded, const std::filesystem::path& program, const server::ServerVariables& rules,
    const client::PresentationSettings& presentation) {
  TRY_STATUS(check_game_code(loaded, program));
  std::unique_ptr<RunningLevel> running(new RunningLevel(loaded, program, rules, presentation));
  TRY_STATUS(running->begin());
  return running;
}

// Game code may fail, even if the server then starts the level again, or go on to another level.
base::Status RunningLevel::check_game() const {
  const std::string failure = find_line(console_, kFailure);
  if (!failure.empty()) return make_error(failure);
  if (server_->game == nullptr) return make_error("the game has ended");
  if (server_->game->setup().map_name != loaded_.name)
    return make_error(fmt::format("game code goes on to {} at once", server_->game->setup().map_name));
  if (!connection_.is_connecting() && !connection_.is_connected())
    return make_error(fmt::format("the player has left the game: {}", connection_.disconnect_reason()));
  return base::Ok{};
}

base::Error RunningLevel::make_error(std::string what) const {
  return {ErrorCode::kUnsupported, std::move(what), fmt::format("maps/{}.bsp", loaded_.name)};
}

// Plays a tick, in which the player stands still. Effects happen at their time.
base::Status RunningLevel::step() {
  now_s_ += server_->settings().tick_s();
  server::step_server(*server_, now_s_);
  connection_.update(now_s_);
  TRY_STATUS(check_game());
  if (!connection_.is_playing()) return base::Ok{};
  const net::Move still{.angles_deg = connection_.state().game().set_angles_deg};
  for (int due = connection_.count_due_moves(now_s_); due > 0; --due) connection_.send_move(still);
  prediction_.begin_frame(connection_, still, now_s_);
  client::ClientState& state = connection_.state();
  return presentation_.advance_unseen(state, state.time_s(), still.angles_deg, settings_);
}

base::Status RunningLevel::begin() {
  TRY_STATUS(server::start_map(*server_, loaded_.name));
  connection_.connect(server_->endpoint.local_address(), now_s_);
  while (!connection_.is_playing()) {
    if (now_s_ > kMaxJoin_s) return make_error("the player cannot join the game");
    TRY_STATUS(step());
  }
  for (const double until_s = now_s_ + kPlayed_s; now_s_ < until_s;) TRY_STATUS(step());
  TRY_STATUS(add_unseen_entities());
  client::ClientState& state = connection_.state();
  const net::Move still{.angles_deg = state.game().set_angles_deg};
  prediction_.begin_frame(connection_, still, now_s_);
  return presentation_.advance(state, state.time_s(), still.angles_deg, settings_);
}

// The updates belong to the last packet, which contained only what the player sees.
base::Status RunningLevel::add_unseen_entities() {
  client::ClientState& state = connection_.state();
  std::vector<client::EntityPlace> seen;
  state.copy_latest_places(seen);
  base::ByteWriter updates;
  server::write_visible_entities(*server_, updates);
  net::MessageReader reader(state.game().dialect);
  reader.begin(updates.view());
  while (true) {
    TRY(const std::optional<net::ServerMessage> message, reader.next());
    if (!message) break;
    const auto& update = std::get<net::EntityUpdate>(*message);
    const bool is_seen = std::ranges::any_of(
        seen, [&](const client::EntityPlace& place) { return place.number == update.number; });
    if (!is_seen) TRY_STATUS(state.apply(*message));
  }
  state.end_packet();
  return base::Ok{};
}

}  // namespace temblor::app
