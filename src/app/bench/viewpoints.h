// Places in a level from which it is looked at: where players start, arrive and watch the intermission.
#pragma once

#include <string>
#include <vector>

#include "math/vec.h"
#include "world/level.h"

namespace temblor::app {

constexpr float kEyeHeight = 22;  // units from a standing player's origin up to the eye

struct Viewpoint {
  std::string classname;
  math::Vec3 eye_world{0.0f};
  math::Vec3 angles_deg{0.0f};  // pitch, yaw, roll
};

// The first info_player_start; else another place where a player may start; else the middle of the level.
Viewpoint start_viewpoint(const world::Level& level);

// Every start of a player (single, cooperative, deathmatch), teleport destination and intermission camera,
// in the order of the level's entities; at least one, as start_viewpoint().
std::vector<Viewpoint> all_viewpoints(const world::Level& level);

math::Vec3 center_of(const world::Level& level);
// The diagonal of its bounds.
double size_of(const world::Level& level);

}  // namespace temblor::app
