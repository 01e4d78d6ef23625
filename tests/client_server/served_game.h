// A server with a small game and our clients, on a network and a clock that the test controls.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assets/library.h"
#include "client/session/connection.h"
#include "command/variables.h"
#include "server/server.h"
#include "server/server_variables.h"
#include "support/programs/bad_network.h"
#include "support/programs/small_game.h"

namespace temblor::test {

// A step of the server at 72 per second.
inline constexpr double kTick_s = 1.0 / 72;

// System and built-in definitions of game/quakec, then a game whose parts tests replace: players walk, and
// doors are boxes that print when they are touched. `extra` precedes the functions that every game has.
std::string small_program(std::string_view extra = "");

// The address of the server.
inline const platform::Address kServedAddress = platform::ip4_address({10, 0, 0, 1}, 26000);

struct ServedGameOptions {
  std::uint32_t max_clients = 4;
  NetworkConditions conditions{};
  std::uint64_t seed = 1;
  // A game folder on top of id1; empty: none.
  std::string mod{};
  // More files of the base folder, by name: "id1/my.cfg".
  std::vector<std::pair<std::string, std::string>> files{};
  // UDP on this machine and its clock, instead of the test's own.
  bool is_real = false;
};

class ServedGame {
 public:
  // `program`: QuakeC source. CHECKs that the compiler is installed.
  explicit ServedGame(std::string_view program = small_program(), const ServedGameOptions& options = {});

  // Requests a connection; run() does the rest.
  std::size_t add_client(std::string name);
  // Advances the clock (waits, on a real one), in steps of 1/72 s; every client that plays sends `move` in
  // each step.
  void run(double seconds, const net::Move& move = {});
  // Runs until the client plays, for at most ten seconds. false: it does not play.
  bool run_until_playing(std::size_t client);
  void command(std::string_view line) { server().console.append(line); }

  server::Server& server() { return *server_; }
  server::Game& game() { return *server_->game; }
  client::Connection& client(std::size_t i) { return *clients_[i]; }
  // Everything that the server printed, and everything that it printed to this client.
  const std::string& console() const { return console_; }
  const std::string& prints(std::size_t client) const { return prints_[client]; }
  // Sounds that this client was sent, and marks that it was asked for.
  std::size_t sounds(std::size_t client) const { return sounds_[client]; }
  std::size_t marks(std::size_t client) const { return marks_[client]; }
  command::Variables& variables() { return variables_; }
  BadNetwork& network() { return network_; }
  const TemporaryFolder& folder() const { return game_folder_.folder(); }
  double now_s() const { return now_s_; }
  // Replaces the program file that the server reads.
  void replace_program(std::string_view program);

 private:
  std::unique_ptr<platform::DatagramSocket> open_socket(const platform::Address& address);
  void advance_clock();

  static constexpr double kBegin_s = 100;

  bool is_real_;
  platform::Address server_address_ = kServedAddress;
  SmallGame game_folder_;
  command::Variables variables_;
  std::unique_ptr<server::ServerVariables> settings_;
  std::unique_ptr<assets::Library> library_;
  BadNetwork network_;
  std::unique_ptr<server::Server> server_;
  std::vector<std::unique_ptr<client::Connection>> clients_;
  std::vector<std::string> prints_;
  std::vector<std::size_t> sounds_, marks_;
  std::string console_;
  double now_s_ = kBegin_s;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace temblor::test
