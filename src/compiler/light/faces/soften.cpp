#include "compiler/light/faces/soften.h"

#include <algorithm>
#include <cstddef>

namespace temblor::compiler {

void soften(int luxels, int width, int height, std::vector<math::Vec3>& io_samples) {
  if (luxels <= 0) return;
  const std::vector<math::Vec3> sharp = io_samples;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      math::Vec3 sum(0.0f);
      float count = 0;
      for (int y = std::max(0, row - luxels); y <= std::min(height - 1, row + luxels); ++y)
        for (int x = std::max(0, column - luxels); x <= std::min(width - 1, column + luxels); ++x, ++count)
          sum += sharp[static_cast<std::size_t>(y * width + x)];
      io_samples[static_cast<std::size_t>(row * width + column)] = sum / count;
    }
}

}  // namespace temblor::compiler
