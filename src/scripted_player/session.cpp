#include "scripted_player/session.h"

#include <fmt/format.h>

namespace temblor::player {
namespace {

constexpr double kMaxJoin_s = 10, kBotsComeFirst_s = 20;
constexpr std::size_t kMaxConsoleBytes = 1 << 20;

}  // namespace

Session::Session(const SessionSetup& setup, vfs::FileSystem files)
    : library_(std::move(files)), settings_(std::make_unique<server::ServerVariables>(variables_)) {
  net::ServerEndpoint::Sockets sockets;
  sockets.push_back(network_.open(1));
  server_ = std::make_unique<server::Server>(server::ServerSetup{.library = library_,
                                                                 .settings = *settings_,
                                                                 .sockets = std::move(sockets),
                                                                 .max_clients = setup.players + setup.bots,
                                                                 .program_file = setup.program_file,
                                                                 .print =
                                                                     [this](std::string_view text) {
                                                                       if (console_.size() < kMaxConsoleBytes)
                                                                         console_ += text;
                                                                     },
                                                                 .seed = setup.seed});
}

base::Result<std::unique_ptr<Session>> Session::start(const SessionSetup& setup) {
  TRY(vfs::FileSystem files, vfs::FileSystem::open(setup.base_folder, setup.games));
  std::unique_ptr<Session> session(new Session(setup, std::move(files)));
  TRY_STATUS(session->begin(setup));
  return session;
}

base::Status Session::begin(const SessionSetup& setup) {
  TRY_STATUS(variables_.set("skill", std::to_string(setup.skill)));
  TRY_STATUS(variables_.set("coop", setup.cooperative ? "1" : "0"));
  TRY_STATUS(variables_.set("deathmatch", setup.bots > 0 ? "1" : "0"));
  TRY_STATUS(variables_.set("bot_fill", std::to_string(setup.bots)));
  TRY_STATUS(variables_.set("sv_cheats", setup.can_cheat ? "1" : "0"));
  TRY_STATUS(server_->start_map(setup.map));
  if (setup.bots > 0) {
    // They look around in the level first.
    for (const double until_s = now_s_ + kBotsComeFirst_s; now_s_ < until_s && has_game();) step({});
    TRY_STATUS(variables_.set("bot_fill", std::to_string(setup.players + setup.bots)));
  }
  for (std::uint32_t i = 0; i < setup.players; ++i) {
    clients_.push_back(std::make_unique<client::Connection>(
        network_.open(),
        client::PlayerSettings{fmt::format("player{}", i + 1), static_cast<std::uint8_t>(4 + i % 8), 1}));
    // Attract loops begin with the level.
    clients_.back()->start_recording();
    clients_.back()->connect(server_->endpoint().local_address(), now_s_);
    // One after the other: their slots are then in order.
    const std::vector<net::Move> still(clients_.size());
    for (const double until_s = now_s_ + kMaxJoin_s; !clients_.back()->is_playing();) {
      if (now_s_ > until_s || !has_game())
        return base::error(base::ErrorCode::kUsage, "player {} does not get into {}: {}\n{}", i + 1,
                           setup.map, clients_.back()->lost_because(), console_);
      step(still);
    }
    slots_.push_back(i);
  }
  return base::Ok{};
}

bool Session::is_everyone_playing() const {
  for (const auto& client : clients_)
    if (!client->is_playing()) return false;
  return true;
}

void Session::step(std::span<const net::Move> moves) {
  now_s_ += kTick_s;
  server_->step(now_s_);
  for (std::size_t i = 0; i < clients_.size(); ++i) {
    client::Connection& client = *clients_[i];
    client.state().events().clear();
    client.update(now_s_);
    client.send_move(moves[i]);
  }
}

}  // namespace temblor::player
