// Method: a spiral that turns by the golden angle from one direction to the next (Vogel, "A better way to
// construct the sunflower head", 1979); the spacing of its heights gives the density.
#include "compiler/light/sources/directions.h"

#include <cmath>
#include <numbers>

namespace temblor::compiler {
namespace {

constexpr double kGoldenAngle = std::numbers::pi * (3 - 2.23606797749978969641);

// Direction i of the spiral, at a height from -1 to 1 on the unit sphere.
math::Vec3 find_spiral_direction(int i, double height) {
  const double radius = std::sqrt(1 - height * height), turn = kGoldenAngle * i;
  return math::Vec3(math::Vec3d(radius * std::cos(turn), radius * std::sin(turn), height));
}

// The middle of part i of [0, 1] in `count` equal parts.
double find_stratum_center(int i, int count) {
  return (i + 0.5) / count;
}

}  // namespace

Frame frame_around(const math::Vec3& up_unit) {
  const math::Vec3 other = std::abs(up_unit.z) < 0.9f ? math::Vec3(0, 0, 1) : math::Vec3(1, 0, 0);
  const math::Vec3 right = glm::normalize(glm::cross(other, up_unit));
  return {right, glm::cross(up_unit, right), up_unit};
}

math::Vec3 cap_direction(int i, int count, double cos_edge) {
  // Slices of a sphere with equal height have equal area.
  return find_spiral_direction(i, 1 - find_stratum_center(i, count) * (1 - cos_edge));
}

math::Vec3 dome_direction(int i, int count) {
  if (i == 0) return {0, 0, 1};
  constexpr double kHighestRad = 72 * std::numbers::pi / 180;
  return find_spiral_direction(i, std::sin(kHighestRad * find_stratum_center(i - 1, count - 1)));
}

math::Vec3 cosine_direction(int i, int count) {
  // Points spread evenly over the disk below have this density on the hemisphere above (Malley's method).
  return find_spiral_direction(i, std::sqrt(1 - find_stratum_center(i, count)));
}

}  // namespace temblor::compiler
