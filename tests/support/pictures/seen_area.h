// How much a level's visibility lets through, by area.
#pragma once

#include <vector>

#include "world/level.h"

namespace temblor::test {

// By face, square units.
std::vector<double> areas_of_faces(const world::Level& level);

// Of the faces of all leaves that the leaf sees, each once; `areas` are those of areas_of_faces.
double visible_area(const world::Level& level, world::LeafIndex from, const std::vector<double>& areas);

}  // namespace temblor::test
