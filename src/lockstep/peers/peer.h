// One computer of a lockstep game, as the game sees it: it gives its own inputs, and gets everybody's. Host
// and guests differ only below this interface (host_peer.h, guest_peer.h).
//
// Ticks count from 0. The inputs of the first GameStart::delay_ticks are empty. Times are of any clock that
// never goes back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lockstep/peers/packets.h"

namespace temblor::lockstep {

class Peer {
 public:
  virtual ~Peer() = default;

  // Receives and sends what is due. Call it every frame, and after add_input().
  virtual void update(double now_s) = 0;
  // The start of the game, once all players are there.
  virtual const GameStart* start() const = 0;
  // The number of this computer's player.
  virtual std::size_t player() const = 0;
  // Players who have joined, and how many the game waits for; 0 if that is not known yet.
  virtual Waiting waiting() const = 0;

  // Adds this player's input for the next tick: the first one is for tick `delay_ticks`.
  virtual void add_input(StampedInput input) = 0;
  // The inputs of all players, which may be taken once, in the order of ticks. Nothing: one has not arrived.
  virtual std::optional<std::vector<StampedInput>> take_tick() = 0;

  // The games differ: sends the hashes of this game's entities to the others.
  virtual void send_hashes(const EntityHashes& hashes) = 0;
  // The hashes of all entities of this player's game, once they have arrived. A guest gets only the host's,
  // for any player.
  virtual const std::optional<EntityHashes>& received_hashes(std::size_t player) const = 0;

  // Whether game time is set by this computer's clock. If not, ticks are played as they arrive.
  virtual bool sets_pace() const = 0;
  // Why the game cannot go on, for the player. Empty: it can.
  virtual const std::string& failure() const = 0;
  // Tells the others that this player leaves. Guests show the host's reason.
  virtual void leave(std::string_view reason) = 0;
};

// Seconds of silence after which another computer counts as gone.
constexpr double kMaxSilence_s = 10;
// The longest time between two packets while something is not acknowledged.
constexpr double kResend_s = 1.0 / 72;

// Collects EntityHashes packets until the hashes of all entities are there.
class HashCollector {
 public:
  void add(const EntityHashes& part);
  const std::optional<EntityHashes>& complete() const { return complete_; }

 private:
  EntityHashes collected_{};
  std::optional<EntityHashes> complete_;
};

// Splits hashes into packets.
std::vector<base::ByteVector> make_hash_packets(const EntityHashes& hashes);

}  // namespace temblor::lockstep
