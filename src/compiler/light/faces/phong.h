// Smooth shading: where faces that ask for it meet at a flat enough angle, light falls as on a curved
// surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/light/faces/sample_points.h"
#include "compiler/light/lit_level.h"
#include "math/vec.h"

namespace temblor::compiler {

class PhongNormals {
 public:
  explicit PhongNormals(const LitLevel& lit);

  // False: the normal of a face is the same everywhere.
  bool is_curved(std::size_t face) const { return !corner_normals_[face].empty(); }
  // The unit normal at a point near the face's plane.
  math::Vec3 at(const LightGrid& grid, const math::Vec3d& point_world) const;

 private:
  std::vector<std::vector<math::Vec3d>> corner_normals_;  // by face; empty: flat
};

}  // namespace temblor::compiler
