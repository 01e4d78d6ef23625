// One side of a plane, in double precision.
#pragma once

#include "math/vec.h"

namespace temblor::compiler::vis {

// All points with above(point) >= 0.
struct HalfSpace {
  math::Vec3d normal{0.0};  // of length 1, points into the half-space
  double distance = 0;

  // A point's distance from the plane in units, negative outside.
  double above(const math::Vec3d& point) const { return glm::dot(normal, point) - distance; }
  HalfSpace flipped() const { return {-normal, -distance}; }
};

}  // namespace temblor::compiler::vis
