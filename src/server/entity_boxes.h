// The boxes with which entities collide, for debug views (r_showbboxes).
#pragma once

#include <vector>

#include "math/vec.h"
#include "server/game.h"

namespace temblor::server {

// The boxes of all entities except the world and this player, in world space; the two corners of a point
// entity's box are equal. QuakeC may have written any numbers into them. Nothing else may use the game during
// the call.
std::vector<math::Bounds> list_entity_boxes(Game& game, std::size_t without_slot);

}  // namespace temblor::server
