// What a player asks for by `give`: weapons, ammunition, health, armor, keys. A cheat; whether it may be
// used is decided before.
#pragma once

#include <span>
#include <string>

#include "server/game.h"

namespace temblor::server {

// Does what `words` say ("give" first) for the player of that slot, who is in the game. The answer is for his
// eyes, one line or more; what is wrong with the words is told there, and nothing is given then.
std::string give(Game& io_game, std::size_t slot, std::span<const std::string> words);

}  // namespace temblor::server
