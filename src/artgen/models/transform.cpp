#include "artgen/models/transform.h"

#include <cmath>
#include <numbers>

namespace temblor::artgen {

glm::dmat3 make_rotation(const math::Vec3d& pitch_yaw_roll_deg) {
  const math::Vec3d angles = pitch_yaw_roll_deg * (std::numbers::pi / 180);
  const double pitch_sin = std::sin(angles.x), pitch_cos = std::cos(angles.x);
  const double yaw_sin = std::sin(angles.y), yaw_cos = std::cos(angles.y);
  const double roll_sin = std::sin(angles.z), roll_cos = std::cos(angles.z);
  // Matrices by columns, which are the images of the axes.
  const glm::dmat3 pitch{{pitch_cos, 0, -pitch_sin}, {0, 1, 0}, {pitch_sin, 0, pitch_cos}};
  const glm::dmat3 yaw{{yaw_cos, yaw_sin, 0}, {-yaw_sin, yaw_cos, 0}, {0, 0, 1}};
  const glm::dmat3 roll{{1, 0, 0}, {0, roll_cos, roll_sin}, {0, -roll_sin, roll_cos}};
  return yaw * pitch * roll;
}

}  // namespace temblor::artgen
