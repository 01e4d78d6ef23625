#include "scripted_player/session/session.h"

#include <fmt/format.h>

namespace temblor::player {
namespace {

// Limits in simulated time, so they do not depend on the machine.
constexpr double kMaxJoin_s = 10, kBotHeadStart_s = 20;
constexpr std::size_t kMaxConsoleBytes = 1 << 20;

}  // namespace

// Socket 1 of the loopback network is the server's; the clients open further ones.
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

// Sets the rules, starts the level, and lets the players join.
base::Status Session::begin(const SessionSetup& setup) {
  TRY_STATUS(variables_.set("skill", std::to_string(setup.skill)));
  TRY_STATUS(variables_.set("coop", setup.cooperative ? "1" : "0"));
  TRY_STATUS(variables_.set("deathmatch", setup.bots > 0 ? "1" : "0"));
  TRY_STATUS(variables_.set("bot_fill", std::to_string(setup.bots)));
  TRY_STATUS(variables_.set("sv_cheats", setup.can_cheat ? "1" : "0"));
  TRY_STATUS(variables_.set("sv_protocol", setup.protocol));
  TRY_STATUS(server::start_map(*server_, setup.map));
  if (setup.bots > 0) {
    // Give the first bot time to explore the level before the other players join.
    for (const double until_s = now_s_ + kBotHeadStart_s; now_s_ < until_s && has_game();) step({});
    TRY_STATUS(variables_.set("bot_fill", std::to_string(setup.players + setup.bots)));
  }
  for (std::uint32_t i = 0; i < setup.players; ++i) {
    clients_.push_back(std::make_unique<client::Connection>(
        network_.open(),
        client::PlayerSettings{fmt::format("player{}", i + 1), static_cast<std::uint8_t>(4 + i % 8), 1}));
    // Record from the first message on, because a demo must begin with the level.
    if (setup.records && i == 0) clients_.back()->start_recording();
    clients_.back()->connect(server_->endpoint.local_address(), now_s_);
    // Players join one after the other, so that their slots are in order.
    const std::vector<net::Move> still(clients_.size());
    for (const double until_s = now_s_ + kMaxJoin_s; !clients_.back()->is_playing();) {
      if (now_s_ > until_s || !has_game())
        return base::error(base::ErrorCode::kUsage, "player {} cannot join {}: {}\n{}", i + 1, setup.map,
                           clients_.back()->disconnect_reason(), console_);
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
  server::step_server(*server_, now_s_);
  for (std::size_t i = 0; i < clients_.size(); ++i) {
    client::Connection& client = *clients_[i];
    client.state().events().clear();
    client.update(now_s_);
    client.send_move(moves[i]);
  }
}

}  // namespace temblor::player
