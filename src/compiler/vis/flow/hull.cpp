// Method: the monotone chain of Andrew, "Another Efficient Algorithm for Convex Hulls in Two Dimensions"
// (1979).
#include "compiler/vis/flow/hull.h"

#include <algorithm>
#include <array>

namespace temblor::compiler::vis {

namespace {

using math::Vec3d;

struct Corner {
  double x, y;  // coordinates in the plane
  Vec3d point;
};

// Positive if `c` is to the left of the line from a to b.
double compute_turn(const Corner& a, const Corner& b, const Corner& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Appends `next`, after dropping corners from the end, down to `keep`, at which the outline would turn right
// or go straight.
std::size_t turn_left(std::span<Corner> hull, std::size_t count, std::size_t keep, const Corner& next) {
  while (count >= keep + 2 && compute_turn(hull[count - 2], hull[count - 1], next) <= 0) --count;
  hull[count] = next;
  return count + 1;
}

}  // namespace

bool contains(const Winding& outer, const Winding& inner, const Vec3d& normal) {
  for (std::size_t i = 0; i < outer.count; ++i) {
    const Vec3d edge = outer.points[i + 1 == outer.count ? 0 : i + 1] - outer.points[i];
    const Vec3d outward = glm::cross(normal, edge);
    const double limit = kEpsilon * glm::length(outward);
    for (const Vec3d& corner : inner.corners())
      if (glm::dot(outward, corner - outer.points[i]) > limit) return false;
  }
  return true;
}

bool grow_hull(Winding& io_winding, const Winding& other, const Vec3d& normal) {
  // Any two axes of the plane. y, x and the normal are right-handed, so left turns in (x, y) are clockwise
  // seen from in front.
  const Vec3d aside = std::abs(normal.x) < 0.7 ? Vec3d(1, 0, 0) : Vec3d(0, 1, 0);
  const Vec3d x_axis = glm::normalize(glm::cross(normal, aside));
  const Vec3d y_axis = glm::cross(x_axis, normal);
  std::array<Corner, 2 * kMaxWindingPoints> corners;
  std::size_t count = 0;
  for (const Winding* winding : {static_cast<const Winding*>(&io_winding), &other})
    for (const Vec3d& point : winding->corners())
      corners[count++] = {glm::dot(x_axis, point), glm::dot(y_axis, point), point};
  std::sort(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(count),
            [](const Corner& a, const Corner& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });

  std::array<Corner, 2 * kMaxWindingPoints + 2> hull;
  std::size_t size = 0;
  for (std::size_t i = 0; i < count; ++i) size = turn_left(hull, size, 0, corners[i]);
  const std::size_t lower = size - 1;
  for (std::size_t i = count - 1; i-- > 0;) size = turn_left(hull, size, lower, corners[i]);
  --size;  // the last corner repeats the first
  if (size < 3 || size > kMaxWindingPoints) return false;
  io_winding.count = size;
  for (std::size_t i = 0; i < size; ++i) io_winding.points[i] = hull[i].point;
  return true;
}

}  // namespace temblor::compiler::vis
