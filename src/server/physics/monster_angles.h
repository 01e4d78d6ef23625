// What a monster's single steps and its way to a goal share.
#pragma once

#include "server/game/entity_fields.h"

namespace temblor::server {

// Who stands, flies or swims.
bool can_step(const Edict& monster);
math::Vec3 step_towards(float yaw_deg, float distance);
// The same direction from 0 to 360, in parts of 1/65536 of a turn, as the original counts; 0 for no number.
float whole_turn_deg(float angle_deg);

}  // namespace temblor::server
