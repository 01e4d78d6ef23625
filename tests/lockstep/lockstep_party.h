// Computers that play a lockstep game of the shipped game's code on the small level, on a network and a clock
// that the test controls.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assets/library.h"
#include "client/session/connection.h"
#include "lockstep/lockstep_game.h"
#include "support/programs/bad_network.h"
#include "support/programs/small_game.h"

namespace temblor::test {

inline constexpr const char* kVersion = "Temblor test";

struct PartyOptions {
  std::size_t players = 2, slots = 0;  // slots: at least one for each player
  NetworkConditions conditions{};
  std::uint64_t seed = 1;
  std::uint8_t delay_ticks = 4;
  std::vector<std::pair<std::string, std::string>> variables{};
};

class LockstepParty {
 public:
  explicit LockstepParty(const PartyOptions& options = {});

  // Each player's client sends its move in each step of 1/72 s. A player who is gone does nothing.
  void run(double seconds, const std::vector<net::Move>& moves = {});
  // Runs until all clients play, for at most ten seconds.
  bool run_until_playing();
  // The player's program ends without a word.
  void kill(std::size_t player) { members_[player] = {}; }

  lockstep::LockstepGame& game(std::size_t player) { return *members_[player].game; }
  client::Connection& client(std::size_t player) { return *members_[player].client; }
  const std::string& prints(std::size_t player) const { return members_[player].prints; }
  BadNetwork& network() { return network_; }
  const lockstep::GameStart& start() const { return start_; }
  lockstep::SimulationSetup setup() const { return {.library = *library_}; }
  const TemporaryFolder& folder() const { return folder_.folder(); }
  double now_s() const { return now_s_; }
  // Lets one more guest ask to join, from a new address.
  std::unique_ptr<lockstep::LockstepGame> make_guest(std::uint64_t id, const std::string& version = kVersion);
  // The host's address.
  static platform::Address host_address();

 private:
  struct Member {
    std::unique_ptr<lockstep::LockstepGame> game{};
    std::unique_ptr<client::Connection> client{};
    std::string prints{};
  };

  void add_member(std::unique_ptr<lockstep::LockstepGame> game);

  SmallGame folder_;
  std::unique_ptr<assets::Library> library_;
  BadNetwork network_;
  lockstep::GameStart start_;
  std::vector<Member> members_;
  double now_s_ = 100;
};

}  // namespace temblor::test
