// Data for clients that number their moves (net/protocol/numbered_moves.h), so that they can predict:
// the settings with which the server plays moves, and the result of their own moves.
#pragma once

#include "net/protocol/numbered_moves.h"
#include "server/game.h"

namespace temblor::server {

// `clock_tick_s` is the time of the clock from one tick to the next.
// Sent when a level starts and whenever one of them changes.
net::MoveParameters make_move_parameters(const GameWorld& world, std::size_t slot, double clock_tick_s);

// The player's state after this tick, in which its move `number` was the last one. Numbers that QuakeC has
// made infinite or NaN are sent as 0.
net::MoveAcknowledgment make_acknowledgment(Game& io_game, std::size_t slot, std::uint32_t number);

}  // namespace temblor::server
