// Directions and conditions that single steps and the chase of a goal share.
#pragma once

#include "server/game/entity_fields.h"

namespace temblor::server {

// Whether it stands on something, flies or swims. A monster in the air cannot step.
bool can_step(const Edict& monster);
// A horizontal vector of this length.
math::Vec3 step_towards(float yaw_deg, float distance);
// The same direction from 0 to 360, in units of 1/65536 of a turn, as the original stores angles. 0 for NaN
// and infinities.
float whole_turn_deg(float angle_deg);

}  // namespace temblor::server
