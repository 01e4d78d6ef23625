#include "compiler/bsp/winding.h"

#include <array>
#include <cmath>

namespace temblor::compiler {
namespace {

constexpr double kShortSide = 0.1;  // units

// Where the line between two points on different sides meets the plane. The same for both directions, so that
// neighbours that are cut alike keep a common corner; exact on planes along an axis.
math::Vec3d meet(math::Vec3d a, math::Vec3d b, double a_distance, double b_distance, const Plane& plane) {
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

double on_plane_for(const math::Vec3d& winding_normal, const math::Vec3d& plane_normal) {
  constexpr double kFlattest = 1e-4;  // sine of the angle: flatter ones are one plane, given twice
  constexpr double kSteep = 0.1;
  const double sine = glm::length(glm::cross(winding_normal, plane_normal));
  return sine < kFlattest || sine > kSteep ? kOnPlane : kOnPlane * sine;
}

Winding whole_plane(const Plane& plane, double extent) {
  // Any direction far from the normal's.
  math::Vec3d up(0, 0, 1);
  if (std::abs(plane.normal.z) > 0.7) up = {1, 0, 0};
  up = glm::normalize(up - plane.normal * glm::dot(up, plane.normal)) * (2 * extent);
  const math::Vec3d right = glm::cross(up, plane.normal);
  const math::Vec3d middle = plane.normal * plane.distance;
  return {middle - right + up, middle + right + up, middle + right - up, middle - right - up};
}

WindingParts split(const Winding& winding, const Plane& plane, double on_plane) {
  const std::size_t count = winding.size();
  // Few windings have more corners; those that do are measured twice.
  constexpr std::size_t kMost = 64;
  std::array<double, kMost> kept;
  const auto distance = [&](std::size_t i) { return i < kMost ? kept[i] : plane.distance_to(winding[i]); };
  bool any_front = false, any_back = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double d = plane.distance_to(winding[i]);
    if (i < kMost) kept[i] = d;
    any_front |= d > on_plane;
    any_back |= d < -on_plane;
  }
  if (!any_front && !any_back) return {};
  if (!any_back) return {winding, {}};
  if (!any_front) return {{}, winding};
  WindingParts parts;
  parts.front.reserve(count + 2);
  parts.back.reserve(count + 2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t next = i + 1 < count ? i + 1 : 0;
    const double a = distance(i), b = distance(next);
    if (a >= -on_plane) parts.front.push_back(winding[i]);
    if (a <= on_plane) parts.back.push_back(winding[i]);
    if ((a > on_plane && b < -on_plane) || (a < -on_plane && b > on_plane)) {
      const math::Vec3d point = meet(winding[i], winding[next], a, b, plane);
      parts.front.push_back(point);
      parts.back.push_back(point);
    }
  }
  return parts;
}

void cut_to_back(Winding& io_winding, const Plane& plane, bool keep_on, double on_plane) {
  bool any_front = false, any_back = false;
  for (const math::Vec3d& point : io_winding) {
    const double d = plane.distance_to(point);
    any_front |= d > on_plane;
    any_back |= d < -on_plane;
  }
  if (!any_front && (any_back || keep_on)) return;
  if (!any_back) {
    io_winding.clear();
    return;
  }
  io_winding = split(io_winding, plane, on_plane).back;
}

bool is_tiny(const Winding& winding) {
  int long_sides = 0;
  for (std::size_t i = 0; i < winding.size(); ++i) {
    const math::Vec3d side = winding[i + 1 < winding.size() ? i + 1 : 0] - winding[i];
    if (glm::dot(side, side) > kShortSide * kShortSide && ++long_sides == 3) return false;
  }
  return true;
}

double area(const Winding& winding) {
  math::Vec3d sum(0.0);
  for (std::size_t i = 2; i < winding.size(); ++i)
    sum += glm::cross(winding[i - 1] - winding[0], winding[i] - winding[0]);
  return glm::length(sum) / 2;
}

}  // namespace temblor::compiler
