// Method: a spiral that turns by the golden angle from one direction to the next (Vogel, "A better way to
// construct the sunflower head", 1979), with its height spaced as the density asks.
#include "compiler/light/sources/directions.h"

#include <cmath>
#include <numbers>

namespace temblor::compiler {
namespace {

constexpr double kGoldenAngle = std::numbers::pi * (3 - 2.23606797749978969641);

math::Vec3 on_spiral(int i, double height) {
  const double radius = std::sqrt(1 - height * height), turn = kGoldenAngle * i;
  return math::Vec3(math::Vec3d(radius * std::cos(turn), radius * std::sin(turn), height));
}

double middle_of(int i, int count) {
  return (i + 0.5) / count;
}

}  // namespace

Frame frame_around(const math::Vec3& up_unit) {
  const math::Vec3 other = std::abs(up_unit.z) < 0.9f ? math::Vec3(0, 0, 1) : math::Vec3(1, 0, 0);
  const math::Vec3 right = glm::normalize(glm::cross(other, up_unit));
  return {right, glm::cross(up_unit, right), up_unit};
}

math::Vec3 cap_direction(int i, int count, double cos_edge) {
  // Slices of equal height of a sphere have equal area.
  return on_spiral(i, 1 - middle_of(i, count) * (1 - cos_edge));
}

math::Vec3 cosine_direction(int i, int count) {
  return on_spiral(i, std::sqrt(1 - middle_of(i, count)));
}

}  // namespace temblor::compiler
