#include "support/levels/level_script_contents.h"

#include <algorithm>
#include <array>
#include <vector>

namespace temblor::test {

std::int32_t find_contents(std::span<const artgen::SmallLevelBox> boxes, const math::Vec3& point) {
  // The last box counts, so search from the end.
  for (auto box = boxes.rbegin(); box != boxes.rend(); ++box) {
    int axis = 0;
    while (axis < 3 && point[axis] > box->bounds.mins[axis] && point[axis] < box->bounds.maxs[axis]) ++axis;
    if (axis == 3) return box->contents;
  }
  return kSolidContents;
}

bool stops_box(std::span<const artgen::SmallLevelBox> boxes, const math::Bounds& box) {
  // The sides of the plan's boxes cut this box into parts; each part has the same contents everywhere.
  std::array<std::vector<float>, 3> cuts;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<float>& lines = cuts[static_cast<std::size_t>(axis)];
    lines = {box.mins[axis], box.maxs[axis]};
    for (const artgen::SmallLevelBox& other : boxes)
      for (const float side : {other.bounds.mins[axis], other.bounds.maxs[axis]})
        if (side > box.mins[axis] && side < box.maxs[axis]) lines.push_back(side);
    std::sort(lines.begin(), lines.end());
  }
  for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i) {
    for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j) {
      for (std::size_t k = 0; k + 1 < cuts[2].size(); ++k) {
        const math::Vec3 low(cuts[0][i], cuts[1][j], cuts[2][k]);
        const math::Vec3 high(cuts[0][i + 1], cuts[1][j + 1], cuts[2][k + 1]);
        if (low.x >= high.x || low.y >= high.y || low.z >= high.z) continue;
        const std::int32_t contents = find_contents(boxes, (low + high) / 2.0f);
        if (contents == kSolidContents || contents == kSkyContents) return true;
      }
    }
  }
  return false;
}

}  // namespace temblor::test
