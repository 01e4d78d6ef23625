// Plays a replay without a window, as fast as possible, and records what one of its players saw.
#pragma once

#include "lockstep/simulation/replay.h"
#include "lockstep/simulation/simulation.h"

namespace temblor::lockstep {

struct PlayedReplay {
  base::ByteVector demo{};      // .dem
  std::uint64_t last_hash = 0;  // equal to the replay's
  std::uint32_t ticks = 0;
  double game_s = 0;
};

// `player`: 0 to the replay's number of players - 1. Fails with kUnsupported if this game has other files,
// or another version of the engine; with kMalformed, and the tick, if the game becomes another one than the
// recorded one.
base::Result<PlayedReplay> play_replay(const Replay& replay, const SimulationSetup& setup,
                                       std::string_view program_version, std::size_t player);

}  // namespace temblor::lockstep
