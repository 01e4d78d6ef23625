#include "compiler/bsp/planes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace temblor::compiler {
namespace {

constexpr double kSameNormal = 1e-5, kSameDistance = 0.01;  // units

// Snaps a normal that rounding alone turned away from an axis to that axis, and the distance of such a plane
// to a whole number. All components count: if only the long one did, a plane tilted by 0.25 degrees would be
// snapped, too, and a wall would move by more than a unit.
void snap(math::Vec3d& io_normal, double& io_distance) {
  for (int axis = 0; axis < 3; ++axis) {
    math::Vec3d others = glm::abs(io_normal);
    others[axis] = 0;
    if (glm::any(glm::greaterThanEqual(others, math::Vec3d(kSameNormal)))) continue;
    const double sign = io_normal[axis] < 0 ? -1 : 1;
    io_normal = math::Vec3d(0.0);
    io_normal[axis] = sign;
    const double whole = std::round(io_distance);
    if (std::abs(io_distance - whole) < kSameDistance) io_distance = whole;
    return;
  }
}

// The axis with the longest component; of nearly equal ones the first, so that rounding never makes two
// planes of one.
int dominant_axis(const math::Vec3d& normal) {
  constexpr double kAsLong = 1e-4;
  const math::Vec3d size = glm::abs(normal);
  const double least = std::max({size.x, size.y, size.z}) - kAsLong;
  return size.x >= least ? 0 : size.y >= least ? 1 : 2;
}

// Hash key: planes of the same kind (along x, y, z, or any other) at nearly the same distance share one.
constexpr std::int64_t kKinds = 4;
std::int64_t make_key(double distance, int axis) {
  constexpr double kStepsAUnit = 8;
  return static_cast<std::int64_t>(std::floor(distance * kStepsAUnit)) * kKinds + axis;
}

}  // namespace

// Looks at all distances within the tolerance. If several planes match, the one with the lowest number wins.
PlaneIndex PlaneSet::find_or_add(math::Vec3d normal, double distance) {
  snap(normal, distance);
  const int dominant = dominant_axis(normal);
  const bool turn = normal[dominant] < 0;
  if (turn) {
    normal = -normal;
    distance = -distance;
  }
  const int axis = normal[dominant] == 1 ? dominant : 3;
  const std::int64_t first = make_key(distance - kSameDistance, axis),
                     last = make_key(distance + kSameDistance, axis);
  std::optional<PlaneIndex> found;
  for (std::int64_t key = first; key <= last; key += kKinds) {
    const auto [begin, end] = by_distance_.equal_range(key);
    for (auto it = begin; it != end; ++it) {
      const Plane& known = (*this)[it->second];
      if (std::abs(known.distance - distance) < kSameDistance &&
          glm::all(glm::lessThan(glm::abs(known.normal - normal), math::Vec3d(kSameNormal))) &&
          (!found || it->second < *found))
        found = it->second;
    }
  }
  if (found) return turn ? flipped(*found) : *found;
  const auto index = static_cast<PlaneIndex>(planes_.size());
  planes_.push_back({normal, distance, axis});
  planes_.push_back({-normal, -distance, axis});
  by_distance_.emplace(make_key(distance, axis), index);
  return turn ? flipped(index) : index;
}

}  // namespace temblor::compiler
