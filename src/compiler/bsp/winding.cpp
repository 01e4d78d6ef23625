#include "compiler/bsp/winding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace temblor::compiler {
namespace {

constexpr double kShortSide = 0.1;  // units

// The point where the line between two points on different sides meets the plane. The same for both
// directions, so that neighbors that are cut alike keep a common corner; exact on axial planes.
math::Vec3d find_crossing(math::Vec3d a, math::Vec3d b, double a_distance, double b_distance,
                          const Plane& plane) {
  if (a_distance < b_distance) {
    std::swap(a, b);
    std::swap(a_distance, b_distance);
  }
  const double share = a_distance / (a_distance - b_distance);
  math::Vec3d point = a + (b - a) * share;
  if (plane.axis < 3) point[plane.axis] = plane.normal[plane.axis] * plane.distance;
  return point;
}

}  // namespace

double on_plane_epsilon(const math::Vec3d& winding_normal, const math::Vec3d& plane_normal) {
  constexpr double kFlattest = 1e-4;  // sine of the angle; below, both are one plane given twice
  constexpr double kSteep = 0.1;      // from here on the strip is narrow
  const double sine = glm::length(glm::cross(winding_normal, plane_normal));
  return sine < kFlattest || sine > kSteep ? kOnPlaneEpsilon : kOnPlaneEpsilon * sine;
}

Winding make_base_winding(const Plane& plane, double extent) {
  // Any direction far from that of the normal.
  math::Vec3d up(0, 0, 1);
  if (std::abs(plane.normal.z) > 0.7) up = {1, 0, 0};
  up = glm::normalize(up - plane.normal * glm::dot(up, plane.normal)) * (2 * extent);
  const math::Vec3d right = glm::cross(up, plane.normal);
  const math::Vec3d middle = plane.normal * plane.distance;
  return {middle - right + up, middle + right + up, middle + right - up, middle - right - up};
}

WindingSide find_side(const Winding& winding, const Plane& plane, double on_plane) {
  bool any_front = false, any_back = false;
  for (const math::Vec3d& point : winding) {
    const double d = plane.distance_to(point);
    any_front |= d > on_plane;
    any_back |= d < -on_plane;
  }
  if (any_front) return any_back ? WindingSide::kBoth : WindingSide::kFront;
  return any_back ? WindingSide::kBack : WindingSide::kOn;
}

// Corners on the plane go to both parts, so the parts share an edge and leave no gap.
WindingParts split(const Winding& winding, const Plane& plane, double on_plane) {
  switch (find_side(winding, plane, on_plane)) {
    case WindingSide::kOn:
      return {};
    case WindingSide::kFront:
      return {winding, {}};
    case WindingSide::kBack:
      return {{}, winding};
    case WindingSide::kBoth:
      break;
  }
  const std::size_t count = winding.size();
  WindingParts parts;
  parts.front.reserve(count + 2);
  parts.back.reserve(count + 2);
  for (std::size_t i = 0; i < count; ++i) {
    const math::Vec3d &begin = winding[i], &end = winding[i + 1 < count ? i + 1 : 0];
    const double a = plane.distance_to(begin), b = plane.distance_to(end);
    if (a >= -on_plane) parts.front.push_back(begin);
    if (a <= on_plane) parts.back.push_back(begin);
    if ((a > on_plane && b < -on_plane) || (a < -on_plane && b > on_plane)) {
      const math::Vec3d point = find_crossing(begin, end, a, b, plane);
      parts.front.push_back(point);
      parts.back.push_back(point);
    }
  }
  return parts;
}

void cut_to_back(Winding& io_winding, const Plane& plane, bool keep_on, double on_plane) {
  const WindingSide side = find_side(io_winding, plane, on_plane);
  if (side == WindingSide::kBack || (side == WindingSide::kOn && keep_on)) return;
  if (side != WindingSide::kBoth) {
    io_winding.clear();
    return;
  }
  // Nearly all windings have so few corners that they can be cut without allocating memory.
  constexpr std::size_t kMaxCorners = 64;
  const std::size_t count = io_winding.size();
  if (2 * count > kMaxCorners) {
    io_winding = split(io_winding, plane, on_plane).back;
    return;
  }
  std::array<math::Vec3d, kMaxCorners> kept;
  std::size_t kept_count = 0;
  double a = plane.distance_to(io_winding.front());
  for (std::size_t i = 0; i < count; ++i) {
    const math::Vec3d &begin = io_winding[i], &end = io_winding[i + 1 < count ? i + 1 : 0];
    const double b = plane.distance_to(end);
    if (a <= on_plane) kept[kept_count++] = begin;
    if ((a > on_plane && b < -on_plane) || (a < -on_plane && b > on_plane))
      kept[kept_count++] = find_crossing(begin, end, a, b, plane);
    a = b;
  }
  io_winding.assign(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(kept_count));
}

bool is_tiny(const Winding& winding) {
  int long_sides = 0;
  for (std::size_t i = 0; i < winding.size(); ++i) {
    const math::Vec3d side = winding[i + 1 < winding.size() ? i + 1 : 0] - winding[i];
    if (glm::dot(side, side) > kShortSide * kShortSide && ++long_sides == 3) return false;
  }
  return true;
}

// The sum over a fan of triangles around the first corner.
double area(const Winding& winding) {
  math::Vec3d sum(0.0);
  for (std::size_t i = 2; i < winding.size(); ++i)
    sum += glm::cross(winding[i - 1] - winding[0], winding[i] - winding[0]);
  return glm::length(sum) / 2;
}

// One of the two lines contains a side (Houle and Toussaint, "Computing the width of a set", 1988).
double compute_width(const Winding& winding) {
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < winding.size(); ++i) {
    const math::Vec3d& begin = winding[i];
    const math::Vec3d side = winding[i + 1 < winding.size() ? i + 1 : 0] - begin;
    const double length = glm::length(side);
    if (length < kOnPlaneEpsilon) continue;
    double farthest = 0;
    for (const math::Vec3d& point : winding)
      farthest = std::max(farthest, glm::length(glm::cross(side, point - begin)) / length);
    width = std::min(width, farthest);
  }
  return std::isfinite(width) ? width : 0;
}

}  // namespace temblor::compiler
