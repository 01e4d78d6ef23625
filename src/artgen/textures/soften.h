// What lies around each texel: where a surface bulges and where it is hollow.
#pragma once

#include "artgen/textures/surface.h"

namespace temblor::artgen {

Cover heights_of(const Surface& surface);

// The mean of the square of 2 * radius + 1 texels around each, twice over, sides wrapping.
Cover softened(const Cover& values, std::int32_t radius);

}  // namespace temblor::artgen
