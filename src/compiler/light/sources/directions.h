// Directions spread evenly over a part of the sphere, the same in every run.
#pragma once

#include "math/vec.h"

namespace temblor::compiler {

// Three orthonormal axes; `up` is the one given.
struct Frame {
  math::Vec3 right{1, 0, 0}, forward{0, 1, 0}, up{0, 0, 1};
};
Frame frame_around(const math::Vec3& up_unit);

inline math::Vec3 in_frame(const Frame& frame, const math::Vec3& local) {
  return frame.right * local.x + frame.forward * local.y + frame.up * local.z;
}

// Direction i of `count`, around +z: evenly over the cap whose edge has that cosine (0: the hemisphere).
math::Vec3 cap_direction(int i, int count, double cos_edge);

// Direction i of `count` around +z, as often as the cosine to it: what a matt surface gathers.
math::Vec3 cosine_direction(int i, int count);

}  // namespace temblor::compiler
