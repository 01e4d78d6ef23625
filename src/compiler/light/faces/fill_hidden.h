// Light for places inside solid, where none can be measured.
#pragma once

#include <cstdint>
#include <span>

#include "math/vec.h"

namespace temblor::compiler {

// Gives the hidden samples of a grid the mean of their neighbors, ring by ring, so that what is visible of
// them blends into the rest. If all samples are hidden, nothing changes. `is_hidden` and `io_samples`: row by
// row, width * height.
void fill_hidden(int width, int height, std::span<const std::uint8_t> is_hidden,
                 std::span<math::Vec3> io_samples);

}  // namespace temblor::compiler
