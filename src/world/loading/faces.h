// Computes a level's faces: kind, texture rectangle, and light samples. The file stores none of them
// directly: the kind follows from the texture's name, and the rectangle from the vertices.
#pragma once

#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

// Fills io_level.faces. The level's edges, vertices, axes, textures and light must be complete.
void make_faces(const formats::Bsp& bsp, Level& io_level);

}  // namespace temblor::world
