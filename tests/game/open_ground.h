// A place in a level with room for a fight.
#pragma once

#include "game/played_level.h"

namespace temblor::test {

constexpr float kOpenGround = 240;  // units from the first player that are free

// Along the floor.
math::Vec3 direction_of(float yaw_deg);

// Puts the first player where the largest monsters have room, and floor, on the whole way to kOpenGround in
// some direction, and returns that. CHECKs that there is one.
float take_a_stand(PlayedLevel& io_game);

}  // namespace temblor::test
