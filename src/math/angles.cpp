#include "math/angles.h"

#include <cmath>
#include <numbers>

namespace temblor::math {

Basis basis_from_angles(const Vec3& pitch_yaw_roll_deg) {
  const Vec3d radians = Vec3d(pitch_yaw_roll_deg) * (std::numbers::pi / 180.0);
  const double sp = std::sin(radians.x), cp = std::cos(radians.x);
  const double sy = std::sin(radians.y), cy = std::cos(radians.y);
  const double sr = std::sin(radians.z), cr = std::cos(radians.z);
  Basis basis;
  basis.forward = {cp * cy, cp * sy, -sp};
  basis.right = {-sr * sp * cy + cr * sy, -sr * sp * sy - cr * cy, -sr * cp};
  basis.up = {cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp};
  return basis;
}

}  // namespace temblor::math
