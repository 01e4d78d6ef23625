#include "artgen/textures/soften.h"

namespace temblor::artgen {
namespace {

// Averages in one direction: the step is (1, 0) or (0, 1). A box blur is separable, so two of these passes
// make one.
Cover average_along(const Cover& values, std::int32_t radius, std::int32_t step_x, std::int32_t step_y) {
  Cover means(values.width, values.height);
  for (std::int32_t y = 0; y < values.height; ++y)
    for (std::int32_t x = 0; x < values.width; ++x) {
      double sum = 0;
      for (std::int32_t i = -radius; i <= radius; ++i) sum += values.at(x + i * step_x, y + i * step_y);
      means.at(x, y) = sum / (2 * radius + 1);
    }
  return means;
}

}  // namespace

Cover copy_heights(const Surface& surface) {
  Cover heights(surface.width, surface.height);
  for (std::size_t i = 0; i < heights.cells.size(); ++i) heights.cells[i] = surface.cells[i].height;
  return heights;
}

Cover soften(const Cover& values, std::int32_t radius) {
  Cover soft = values;
  for (std::int32_t pass = 0; pass < 2; ++pass)
    soft = average_along(average_along(soft, radius, 1, 0), radius, 0, 1);
  return soft;
}

}  // namespace temblor::artgen
