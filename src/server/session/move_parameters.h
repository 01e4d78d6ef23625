// What clients that number their moves are told: how moves are played, and what came of theirs.
#pragma once

#include "net/protocol/numbered_moves.h"
#include "server/game.h"

namespace temblor::server {

// `clock_tick_s`: of the clock, from one tick to the next.
net::MoveParameters move_parameters(const GameWorld& world, std::size_t slot, double clock_tick_s);

// The player as he is after a tick.
net::MoveAcknowledgement acknowledgement(Game& io_game, std::size_t slot, std::uint32_t number);

}  // namespace temblor::server
