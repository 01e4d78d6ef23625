// The pitch at which a player on stairs looks along them: six probes ahead measure the floor, and the rise of
// the steps gives the angle. Clients turn the view there while the mouse does not.
#pragma once

#include "server/game/game_world.h"

namespace temblor::server {

// Sets idealpitch of a player on the ground, from the floor's height at six points ahead of it. It is 0 on
// flat ground, and stays as it was if the steps are uneven or too few.
void set_ideal_pitch(GameWorld& io_world, vm::EntityIndex player);

}  // namespace temblor::server
