// Converts a running game to a saved game (formats/game/sav.h) and back. The format is stock Quake's: text,
// with the name and value of every saved global and field, so that saves survive small changes of the
// program.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "formats/game/sav.h"
#include "server/game.h"

namespace temblor::server {

// The game's whole state. `comment` is cut to what a file has room for.
formats::Sav make_save(const Game& game, std::string comment);

// Names and values of an entity's fields that are not 0, as saves contain them.
formats::SavPairs nonzero_fields(const Game& game, vm::EntityIndex index);

// How many entity numbers a save needs: up to the last one that is in use.
std::size_t count_used_entities(const formats::Sav& sav);

// Puts a saved state into a game that was just started on the same level: globals, entities, light styles and
// the clock. Player 1 is then as it was, and must not be spawned again. Returns what this program does not
// know of the save, one line each. Fails if the save has more entities than the machine allows, or none for
// the player.
base::Result<std::vector<std::string>> restore(const formats::Sav& sav, Game& io_game);

}  // namespace temblor::server
