// Moves, turns and scales brushes together with their textures ("texture lock" in editors).
#pragma once

#include <array>

#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::compiler {

// An affine map: position' = columns[0] * x + columns[1] * y + columns[2] * z + offset.
struct Placement {
  std::array<math::Vec3d, 3> columns{math::Vec3d(1, 0, 0), math::Vec3d(0, 1, 0), math::Vec3d(0, 0, 1)};
  math::Vec3d offset{0.0};

  math::Vec3d apply(const math::Vec3d& position) const {
    return columns[0] * position.x + columns[1] * position.y + columns[2] * position.z + offset;
  }
  // The factor by which volumes grow; negative: mirrored.
  double determinant() const { return glm::dot(columns[0], glm::cross(columns[1], columns[2])); }
};

// Applies first `inner`, then `outer`.
Placement combine(const Placement& outer, const Placement& inner);

// Moves a side; each point keeps its texel. The placement's determinant is not 0. Standard alignment becomes
// Valve's, which allows any angle. A side whose points are on one line keeps its alignment.
formats::MapSide place_side(const formats::MapSide& side, const Placement& placement);

}  // namespace temblor::compiler
