// Draws the path of a leak, for mappers without an editor that shows .pts files.
#pragma once

#include <span>

#include "base/bytes.h"
#include "base/result.h"
#include "formats/levels/bsp.h"
#include "math/vec.h"

namespace temblor::app {

// Returns a PNG with two orthographic views, from above and from the south. The edges of the level's faces
// are gray; the path of the leak is orange, from a green dot at its entity to a red dot in the void.
//
//   +--------------+
//   |  from above  |   x to the right, y up
//   +--------------+
//   | from south   |   x to the right, z up
//   +--------------+
base::Result<base::ByteVector> draw_leak(const formats::Bsp& bsp, std::span<const math::Vec3d> path_world);

}  // namespace temblor::app
