// Many monsters for measurements: copies of a level's own.
#pragma once

#include <cstddef>
#include <vector>

#include "base/result.h"
#include "server/game.h"

namespace temblor::bench {

std::vector<vm::EntityIndex> list_monsters(server::GameWorld& world);
// Near those of the level but apart, until there are `count`, or no room is found.
base::Status add_monsters(std::size_t count, server::Game& io_game);
// All of them are after the first player, who cannot be hurt. For programs that have start_hunt().
base::Status set_upon_player(server::Game& io_game);

}  // namespace temblor::bench
