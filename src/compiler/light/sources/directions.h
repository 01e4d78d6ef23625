// Directions that cover a part of the sphere evenly, the same in every run.
#pragma once

#include "math/vec.h"

namespace temblor::compiler {

// Three orthonormal axes.
struct Frame {
  math::Vec3 right{1, 0, 0}, forward{0, 1, 0}, up{0, 0, 1};
};
// Returns axes with a given `up`.
Frame frame_around(const math::Vec3& up_unit);

// Converts a direction from the frame to world space.
inline math::Vec3 in_frame(const Frame& frame, const math::Vec3& local) {
  return frame.right * local.x + frame.forward * local.y + frame.up * local.z;
}

// Direction i of `count`, spread evenly around +z over the cap whose edge has that cosine (0: a hemisphere).
math::Vec3 cap_direction(int i, int count, double cos_edge);

// Direction i of `count` to the dome of the sky: number 0 is +z, and the others are as many at each elevation
// from the horizon to 72 degrees. This is how mappers know domes: rings of 16 suns at 9, 27, 45, and 63
// degrees, and one above.
math::Vec3 dome_direction(int i, int count);

// Direction i of `count` around +z, distributed by the cosine of the angle to it: what a matte surface
// gathers.
math::Vec3 cosine_direction(int i, int count);

}  // namespace temblor::compiler
