// Brush models that are levels by themselves (boxes of ammunition and health, maps/b_*.bsp), joined to the
// level that shows them: then they are models of it like its doors and lifts, and nobody else need know.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

struct JoinedLevel {
  std::shared_ptr<const Level> level;
  std::vector<ModelIndex> models;  // by element of `others`: what was its world
};

// `base` with all faces, hulls, textures and light of the others, which keep what light they have, gray or
// colored. Entities, PVS and everything else that there is one of are those of `base`. Without others,
// `base` itself.
JoinedLevel join_levels(const std::shared_ptr<const Level>& base,
                        std::span<const std::shared_ptr<const Level>> others);

}  // namespace temblor::world
