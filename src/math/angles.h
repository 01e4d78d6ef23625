// Quake's angles: pitch (down is positive), yaw (counter-clockwise from +x, seen from above), roll, in
// degrees. The stock renderer negates the pitch of alias models, but not that of brush models.
#pragma once

#include "math/vec.h"

namespace temblor::math {

// Orthonormal. At angles 0, forward is +x, left is +y, and up is +z.
struct Basis {
  Vec3d forward{1, 0, 0}, right{0, -1, 0}, up{0, 0, 1};
};

// Converts angles to the directions of the viewer's axes. Any finite angles are valid. A positive roll tilts
// the viewer's right side down. Computed in double precision.
Basis basis_from_angles(const Vec3& pitch_yaw_roll_deg);

}  // namespace temblor::math
