// Sutherland and Hodgman, "Reentrant polygon clipping" (1974), with corners within kEpsilon of the plane kept
// on both sides.
#include "compiler/vis/flow/winding.h"

#include <algorithm>

namespace temblor::compiler::vis {

Left cut(Winding& io_winding, const HalfSpace& keep) {
  std::array<double, kMaxWindingPoints + 1> above;
  double highest = -1, lowest = 1;
  const std::size_t count = io_winding.count;
  for (std::size_t i = 0; i < count; ++i) {
    above[i] = keep.above(io_winding.points[i]);
    highest = std::max(highest, above[i]);
    lowest = std::min(lowest, above[i]);
  }
  if (highest <= kEpsilon) {
    io_winding.count = 0;
    return Left::kNothing;
  }
  if (lowest >= -kEpsilon) return Left::kWhole;
  if (count + 1 > kMaxWindingPoints) return Left::kWhole;  // a convex polygon gains at most one corner

  const Winding whole = io_winding;
  std::size_t kept = 0;
  above[count] = above[0];
  for (std::size_t i = 0; i < count; ++i) {
    const math::Vec3d& from = whole.points[i];
    const bool in = above[i] >= -kEpsilon;
    if (in) io_winding.points[kept++] = from;
    const bool crosses = (above[i] > kEpsilon && above[i + 1] < -kEpsilon) ||
                         (above[i] < -kEpsilon && above[i + 1] > kEpsilon);
    if (!crosses || kept == kMaxWindingPoints) continue;
    const math::Vec3d& to = whole.points[i + 1 == count ? 0 : i + 1];
    io_winding.points[kept++] = from + (to - from) * (above[i] / (above[i] - above[i + 1]));
  }
  io_winding.count = kept >= 3 ? kept : 0;
  return kept >= 3 ? Left::kSome : Left::kNothing;
}

}  // namespace temblor::compiler::vis
