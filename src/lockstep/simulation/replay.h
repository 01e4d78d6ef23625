// A replay: the start of a lockstep game, and all inputs. It contains no pictures and no state, so it takes a
// few kilobytes per minute. Anyone who has the game's files can play it, and gets
// the same game.
//
//   "TmRp", u8 version, u32 ticks, u64 hash of the last state, u32 size of what follows unpacked,
//   then packed by zlib:  the start | each tick: the inputs of all players | a byte of each tick's hash
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/result.h"
#include "lockstep/game_start.h"
#include "lockstep/peers/client_input.h"
#include "lockstep/peers/packets.h"

namespace temblor::lockstep {

struct Replay {
  GameStart start{};
  std::vector<std::vector<ClientInput>> ticks{};  // by tick, then by player
  std::vector<std::uint8_t> hash_bytes{};         // after each tick
  std::uint64_t last_hash = 0;
};

class ReplayWriter {
 public:
  explicit ReplayWriter(const GameStart& start);
  // Adds the inputs of a tick, and the hash of the state after it.
  void add(std::span<const StampedInput> inputs, std::uint64_t hash);
  std::uint32_t ticks() const { return static_cast<std::uint32_t>(hash_bytes_.size()); }
  // The bytes of the file.
  base::ByteVector finish() const;

 private:
  base::ByteWriter content_;
  std::array<InputHistory, kMaxPlayers> histories_{};
  std::vector<std::uint8_t> hash_bytes_;
  std::uint64_t last_hash_ = 0;
};

// kMalformed for a damaged file, kUnsupported for one of another version, kTooLarge above a day of play.
base::Result<Replay> read_replay(base::Bytes bytes);

}  // namespace temblor::lockstep
