// The area of the faces that a level's visibility includes.
#pragma once

#include <vector>

#include "world/level.h"

namespace temblor::test {

// The area of each face in square units.
std::vector<double> compute_face_areas(const world::Level& level);

// The area of the faces of all leaves in the leaf's PVS, each counted once. `areas`: from
// compute_face_areas().
double visible_area(const world::Level& level, world::LeafIndex from, const std::vector<double>& areas);

}  // namespace temblor::test
