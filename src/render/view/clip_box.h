// Boxes of the BSP tree against the frustum. A header of its own, because walks through the tree call it for
// every node.
#pragma once

#include <algorithm>
#include <array>

#include "math/vec.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// The frustum planes that a box may cross, given those that its parent's box may cross (ClipFlags); kOutside
// if the box is completely behind one of them. A node inside a plane spares all nodes below it that test
// (Abrash, "Sorted Spans in Action").
constexpr int kOutside = -1;
inline int clip_box(const std::array<FrustumPlane, 5>& frustum, const math::Bounds& bounds, int flags) {
  for (int i = 0; i < 5; ++i) {
    if ((flags & 1 << i) == 0) continue;
    const FrustumPlane& plane = frustum[static_cast<std::size_t>(i)];
    double farthest = plane.offset, nearest = plane.offset;
    for (int axis = 0; axis < 3; ++axis) {
      const double at_min = plane.normal[axis] * static_cast<double>(bounds.mins[axis]);
      const double at_max = plane.normal[axis] * static_cast<double>(bounds.maxs[axis]);
      farthest += std::max(at_min, at_max);
      nearest += std::min(at_min, at_max);
    }
    if (farthest < 0) return kOutside;
    if (nearest >= 0) flags &= ~(1 << i);
  }
  return flags;
}

}  // namespace temblor::render
