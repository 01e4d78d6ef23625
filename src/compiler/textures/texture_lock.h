// Brushes moved, turned and scaled with their textures on them.
#pragma once

#include <array>

#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::compiler {

// position' = columns[0] * x + columns[1] * y + columns[2] * z + offset.
struct Placement {
  std::array<math::Vec3d, 3> columns{math::Vec3d(1, 0, 0), math::Vec3d(0, 1, 0), math::Vec3d(0, 0, 1)};
  math::Vec3d offset{0.0};

  math::Vec3d apply(const math::Vec3d& position) const {
    return columns[0] * position.x + columns[1] * position.y + columns[2] * position.z + offset;
  }
  // Volumes grow by it; negative: mirrored.
  double determinant() const { return glm::dot(columns[0], glm::cross(columns[1], columns[2])); }
};

// First `inner`, then `outer`.
Placement combined(const Placement& outer, const Placement& inner);

// The side where the placement (its determinant is not 0) puts it, every point of it with the texel it had.
// Standard alignment becomes Valve's, which can lie at any angle. A side whose points span no plane keeps its
// alignment.
formats::MapSide placed(const formats::MapSide& side, const Placement& placement);

}  // namespace temblor::compiler
