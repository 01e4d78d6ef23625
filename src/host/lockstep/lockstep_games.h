// Lockstep games (lockstep/lockstep_game.h), and their replays.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/result.h"

namespace temblor::host {

struct Host;

// Inputs take effect this many ticks after they are made, unless the host of a game chooses another delay.
constexpr std::uint8_t kDefaultDelayTicks = 4;
constexpr std::uint8_t kMaxDelayTicks = 36;

// Starts a game on a level for 1 to lockstep::kMaxPlayers players, which begins when all are there. A game of
// one player needs no network, and its inputs take effect at once. If there is no such level, or the port is
// not free, the running game continues.
base::Status host_lockstep(Host& io_host, std::string_view map, std::uint8_t players,
                           std::uint8_t delay_ticks = kDefaultDelayTicks);
// Joins such a game: "HOST" or "HOST:PORT".
base::Status join_lockstep(Host& io_host, std::string_view address);

// Writes the replay of a lockstep game that has ended as lockstepNNNN.replay. Does nothing if there is none.
base::Status save_replay(Host& io_host);
// Plays a replay as one of its players saw it, as a demo. Blocks while it simulates the whole game. `player`:
// from 1 on.
base::Status play_replay(Host& io_host, std::string_view file, std::size_t player);

}  // namespace temblor::host
