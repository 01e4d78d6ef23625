// A level's faces as the renderer wants them: their kind, the rectangle of texels that covers them, their
// light.
#pragma once

#include "base/result.h"
#include "formats/levels/bsp.h"
#include "world/level.h"

namespace temblor::world {

// Fills io_level.faces. The level has its edges, vertices, axes, textures and light already.
base::Status make_faces(const formats::Bsp& bsp, Level& io_level);

}  // namespace temblor::world
