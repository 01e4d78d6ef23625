// Smooth shading (Phong, "Illumination for computer generated pictures", 1975): where faces with _phong meet
// at a small enough angle, they are lit as one curved surface.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "compiler/light/faces/sample_points.h"
#include "compiler/light/lit_level.h"
#include "math/vec.h"

namespace temblor::compiler {

// The normals at the corners of all faces. Never changes, so all threads may share it.
class PhongNormals {
 public:
  explicit PhongNormals(const LitLevel& lit);

  // False: the face has one normal everywhere.
  bool is_curved(std::size_t face) const { return !corner_normals_[face].empty(); }
  // The unit normals at its corners, in their order; empty: it is flat.
  std::span<const math::Vec3d> corners(std::size_t face) const { return corner_normals_[face]; }
  // The unit normal at a point near the face's plane.
  math::Vec3 at(const LightGrid& grid, const math::Vec3d& point_world) const;

 private:
  std::vector<std::vector<math::Vec3d>> corner_normals_;  // by face; empty: flat
};

}  // namespace temblor::compiler
