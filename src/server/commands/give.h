// The `give` command: weapons, ammunition, health, armor, keys. A cheat; the caller has checked that it is
// allowed.
#pragma once

#include <span>
#include <string>

#include "server/game.h"

namespace temblor::server {

// Runs the command that `words` contain ("give" first) for the player of this slot, who is in the game.
// Returns the answer for the player, one or more lines. If the words make no sense, the answer says why, and
// nothing is given.
std::string give(Game& io_game, std::size_t slot, std::span<const std::string> words);

}  // namespace temblor::server
