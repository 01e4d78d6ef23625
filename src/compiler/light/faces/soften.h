// Smooths the edges of shadows after the fact, by averaging neighboring luxels (-soft in other compilers).
#pragma once

#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

// Gives each luxel the mean of the square that reaches `luxels` luxels to each side of it; the map's edge
// cuts the square. 0: no change. `io_samples`: width x height, row by row.
void soften(int luxels, int width, int height, std::vector<math::Vec3>& io_samples);

}  // namespace temblor::compiler
