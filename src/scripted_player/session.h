// A game of a real server and real clients in one process, on a clock that its owner turns.
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

constexpr double kTick_s = 1.0 / 72;

struct SessionSetup {
  std::filesystem::path base_folder;
  std::vector<std::string> games;        // over id1
  std::filesystem::path program_file{};  // empty: the game folders' progs.dat
  std::string map;
  int skill = 1;
  std::uint64_t seed = 1;
  std::uint32_t players = 1;
  bool cooperative = false;
  std::uint32_t bots = 0;  // of a deathmatch, which it is with any; beside the players
  bool can_cheat = false;  // god and the like, with several players too
};

class Session {
 public:
  // The level is running, and all players are in it. Errors name the file that cannot be used.
  static base::Result<std::unique_ptr<Session>> start(const SessionSetup& setup);

  // A tick: the clients' moves, by number of player, arrive, the server plays them, and what it says is read.
  void step(std::span<const net::Move> moves);

  std::size_t player_count() const { return clients_.size(); }
  server::Server& server() { return *server_; }
  server::Game& game() { return *server_->game(); }
  bool has_game() { return server_->game() != nullptr; }
  client::Connection& client(std::size_t i) { return *clients_[i]; }
  bool is_everyone_playing() const;
  // Of players' slots on the server, which need not be in the order of the clients.
  std::size_t slot_of(std::size_t client) const { return slots_[client]; }
  // The tick's own: what clients were told once (sounds, flashes) is forgotten at the next.
  double now_s() const { return now_s_; }
  // All that the server has printed.
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
