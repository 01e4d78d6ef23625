// Blurs heights. The difference between a height and its blurred surroundings shows bulges and hollows.
#pragma once

#include "artgen/textures/surface.h"

namespace temblor::artgen {

// The heights of all texels.
Cover copy_heights(const Surface& surface);

// A box blur over the square of 2 * radius + 1 texels around each texel, applied twice, which is smoother.
// Wraps around at the sides.
Cover soften(const Cover& values, std::int32_t radius);

}  // namespace temblor::artgen
