// A game to a saved game and back.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "formats/game/sav.h"
#include "server/game.h"

namespace temblor::server {

// `comment` is cut to what a file has room for.
formats::Sav save_of(const Game& game, std::string comment);

// Fields of an entity that are not 0, as a save has them.
formats::SavPairs entity_as_text(const Game& game, vm::EntityIndex index);

// Numbers of entities that it needs: up to the last one that is in use.
std::size_t entities_of(const formats::Sav& sav);

// Puts everything that was saved into a game that was just started on the same level: globals, entities,
// light styles and the clock; player 1 is then as he was, and must not be put in anew. Returns what of the
// save this program does not know, a line each. Fails where the save has more entities than there may be, or
// none for the player.
base::Result<std::vector<std::string>> restore(const formats::Sav& sav, Game& io_game);

}  // namespace temblor::server
