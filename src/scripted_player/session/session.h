// A server and its clients in one process, connected by a loopback network, on a simulated clock. The players
// are real clients: they send only moves and console commands, so a demo of them is a real demo.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "assets/library.h"
#include "base/result.h"
#include "client/session/connection.h"
#include "command/variables.h"
#include "net/protocol/client_message.h"
#include "net/transport/loopback.h"
#include "server/server.h"
#include "server/server_variables.h"

namespace temblor::player {

constexpr double kTick_s = 1.0 / 72;  // one server tick and one move of every client

struct SessionSetup {
  // The directory that contains id1.
  std::filesystem::path base_folder;
  // Game directories in addition to id1.
  std::vector<std::string> games;
  // Game code; empty: progs.dat of the game directories.
  std::filesystem::path program_file{};
  std::string map;
  int skill = 1;
  // Seed of the server's random numbers.
  std::uint64_t seed = 1;
  std::uint32_t players = 1;
  bool cooperative = false;
  // In addition to the players. With bots, the game is a deathmatch.
  std::uint32_t bots = 0;
  // Allows "god" in games of several players.
  bool can_cheat = false;
  // Records a demo of the first player.
  bool records = false;
  // A value of sv_protocol.
  std::string protocol = "auto";
};

// One tick, in order:
//
//   server: receive the moves of the last tick -> simulate -> send   clients: receive -> send moves
class Session {
 public:
  // Starts the level and waits until all players are in it. Errors name the file that cannot be used.
  static base::Result<std::unique_ptr<Session>> start(const SessionSetup& setup);

  // Plays a tick. `moves` has one move per client.
  void step(std::span<const net::Move> moves);

  std::size_t player_count() const { return clients_.size(); }
  server::Server& server() { return *server_; }
  // Only if has_game(). An error of the game code ends the game.
  server::Game& game() { return *server_->game; }
  bool has_game() { return server_->game != nullptr; }
  client::Connection& client(std::size_t i) { return *clients_[i]; }
  bool is_everyone_playing() const;
  // Slot of a client on the server.
  std::size_t slot(std::size_t client) const { return slots_[client]; }
  // Time of the simulated clock.
  double now_s() const { return now_s_; }
  // Everything that the server has printed, up to 1 MiB.
  const std::string& console() const { return console_; }

 private:
  explicit Session(const SessionSetup& setup, vfs::FileSystem files);
  base::Status begin(const SessionSetup& setup);

  command::Variables variables_;
  assets::Library library_;
  std::unique_ptr<server::ServerVariables> settings_;
  net::LoopbackNetwork network_;
  std::unique_ptr<server::Server> server_;
  std::vector<std::unique_ptr<client::Connection>> clients_;
  std::vector<std::size_t> slots_;
  std::string console_;
  double now_s_ = 100;
};

}  // namespace temblor::player
