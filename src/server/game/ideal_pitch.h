// Where a player on stairs should look: up or down along them.
#pragma once

#include "server/game_world.h"

namespace temblor::server {

// Sets idealpitch of a player on the ground from the floor's height at six places ahead of him: 0 on flat
// ground; unchanged where the steps are uneven or too few to tell.
void set_ideal_pitch(GameWorld& io_world, vm::EntityIndex player);

}  // namespace temblor::server
