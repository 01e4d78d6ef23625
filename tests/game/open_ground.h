// Finds a place in a level with room for a fight.
#pragma once

#include "game/played_level.h"

namespace temblor::test {

constexpr float kOpenGround = 240;  // units from the first player that are free

// A horizontal unit vector.
math::Vec3 yaw_direction(float yaw_deg);

// Puts the first player where the largest monsters have room and floor on the whole path of kOpenGround units
// in some direction, and returns that direction. CHECKs that there is such a place.
float take_a_stand(PlayedLevel& io_game);

}  // namespace temblor::test
