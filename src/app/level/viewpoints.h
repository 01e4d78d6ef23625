// Viewpoints in a level for pictures and measurements: where players start, arrive by teleporter, and watch
// the intermission.
#pragma once

#include <string>
#include <vector>

#include "math/vec.h"
#include "world/level.h"
#include "world/spawn_rules.h"

namespace temblor::app {

// Units from the origin of a standing player up to the eye.
constexpr float kEyeHeight = 22;

struct Viewpoint {
  // The entity's class name, for messages.
  std::string classname;
  math::Vec3 eye_world{0.0f};
  // Pitch, yaw, and roll.
  math::Vec3 angles_deg{0.0f};
};

// Returns the first info_player_start (in deathmatch, the first info_player_deathmatch) that `rules` do not
// exclude; otherwise another viewpoint; otherwise the center of the level.
Viewpoint find_start_viewpoint(const world::Level& level, const world::SpawnRules& rules = {});

// Returns every player start (single player, cooperative, deathmatch), teleport destination, and intermission
// camera, in the order of the level's entities; find_start_viewpoint() if there is none.
std::vector<Viewpoint> list_viewpoints(const world::Level& level);

// Returns the center of the level's bounds.
math::Vec3 level_center(const world::Level& level);
// Returns the length of the diagonal of the level's bounds.
double level_diagonal(const world::Level& level);

}  // namespace temblor::app
