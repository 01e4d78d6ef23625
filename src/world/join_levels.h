// Joins brush models that are separate level files (ammunition and health boxes, maps/b_*.bsp) to the level
// that uses them. They become models of that level like its doors and lifts, so no other code needs a special
// case.
//
// Method: append each list of the other level to the same list of the base level, and add the old size of
// that list to every index that refers to it.
//
//   models:  | base: world, doors, ... | b_shell0: world | b_bh25: world | ...
//                                        ^ models[0]       ^ models[1] of JoinedLevel
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

struct JoinedLevel {
  std::shared_ptr<const Level> level;
  std::vector<ModelIndex> models;  // one per element of `others`: the model that was its world
};

// Returns a new level: `base` with the faces, hulls, textures, and light of the others added. If one level
// has colored light, the gray light of the others becomes equal parts of red, green, and blue. Entities, PVS,
// and everything else that exists once come from `base`. Without others, returns `base` itself.
JoinedLevel join_levels(const std::shared_ptr<const Level>& base,
                        std::span<const std::shared_ptr<const Level>> others);

}  // namespace temblor::world
