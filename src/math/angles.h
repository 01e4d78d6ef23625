// Quake's angles: pitch (down is positive), yaw (counter-clockwise from +x), roll, in degrees.
#pragma once

#include "math/vec.h"

namespace temblor::math {

// Orthonormal; `right` points right of `forward`, so left of it is +y at angles 0.
struct Basis {
  Vec3d forward{1, 0, 0}, right{0, -1, 0}, up{0, 0, 1};
};

Basis basis_from_angles(const Vec3& pitch_yaw_roll_deg);

}  // namespace temblor::math
