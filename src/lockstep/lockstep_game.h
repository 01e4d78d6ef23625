// A lockstep game on one computer: all peers simulate, and send each other only their players' inputs.
//
//   real client <-> ClientLink -> own input of tick t + delay -> Peer <-> other computers
//                       ^                                          |
//                       +------ Simulation <-- inputs of tick t ---+--> ReplayWriter
//
// Source: Michael Abrash, "Quake's 3-D Engine: The Big Picture", which describes the networking of the game
// before Quake.
//
// Peers compare hashes of their games at every tick. If two differ, the game ends with a report that names
// the tick and the first entity that differs.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "lockstep/peers/packets.h"
#include "lockstep/simulation/client_link.h"
#include "lockstep/simulation/game_hashes.h"
#include "lockstep/simulation/replay.h"
#include "lockstep/simulation/simulation.h"

namespace temblor::lockstep {

class Peer;

class LockstepGame {
 public:
  // Waits until `start.players` are there, and begins. `socket` may be null for one player.
  static std::unique_ptr<LockstepGame> host(SimulationSetup setup, GameStart start,
                                            std::unique_ptr<platform::DatagramSocket> socket);
  // Joins the game at this address. `guest_id`: a random number.
  static std::unique_ptr<LockstepGame> join(SimulationSetup setup, std::string program_version,
                                            std::unique_ptr<platform::DatagramSocket> socket,
                                            const platform::Address& host, std::uint64_t guest_id);
  // `peer` gathers the players, and then the game begins. `program_version`: of the engine.
  LockstepGame(SimulationSetup setup, std::string program_version, std::unique_ptr<Peer> peer);
  // Tells the others that this player leaves.
  ~LockstepGame();

  // The socket for this player's client, and the address to which it connects.
  std::unique_ptr<platform::DatagramSocket> open_client_socket() { return network_.open(); }
  platform::Address client_server() const { return link_.address(); }

  // Receives, plays the ticks that are due, and sends. `now_s`: of any clock that never goes back.
  void step(double now_s);
  // Why the game has ended, for the player; empty: it has not.
  const std::string& ended() const { return ended_; }
  bool has_begun() const { return simulation_ != nullptr; }
  // CHECKs that the game has begun.
  Simulation& simulation() { return *simulation_; }
  std::uint32_t ticks() const { return ticks_; }
  // Nothing before the game has begun.
  const ReplayWriter* replay() const { return replay_ ? &*replay_ : nullptr; }

 private:
  // How far back games can be compared, in ticks: further than inputs are late.
  static constexpr std::size_t kKeptHashes = 256;

  struct Difference {
    std::uint32_t tick = 0;  // ticks that had been played
    std::size_t player = 0;  // whose game differs from this one
    double found_at_s = 0, sent_at_s = -1;
  };

  net::LoopbackNetwork network_;
  SimulationSetup setup_;
  std::string program_version_;
  std::unique_ptr<Peer> peer_;
  ClientLink link_;
  std::unique_ptr<Simulation> simulation_;
  std::optional<ReplayWriter> replay_;
  std::array<GameHashes, kKeptHashes> hashes_{};  // by the number of ticks that had been played, modulo
  std::array<bool, kMaxPlayers> has_left_{};
  std::uint32_t ticks_ = 0, next_input_ = 0;
  std::optional<Difference> difference_;
  std::uint8_t shown_joined_ = 0;
  double now_s_ = -1, unplayed_s_ = 0;
  std::string ended_;

  void show_waiting();
  base::Status begin();
  void play_due_ticks();
  void add_due_inputs();
  bool has_same_games(const std::vector<StampedInput>& inputs);
  void play(const std::vector<StampedInput>& inputs);
  void compare_games();
  std::string describe_difference(const std::optional<EntityHashes>& theirs);
  void end(std::string reason);
};

}  // namespace temblor::lockstep
