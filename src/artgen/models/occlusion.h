// Ambient occlusion: the part of the hemisphere over a point that the model itself hides. It darkens creases
// on skins.
#pragma once

#include <cstddef>
#include <vector>

#include "artgen/models/mesh.h"
#include "math/vec.h"

namespace temblor::artgen {

// Holds the triangles of a mesh at rest, and for each triangle a list of those close enough to matter.
class Occlusion {
 public:
  // Surfaces that are farther away than `reach` units do not occlude. The work is quadratic in the number of
  // triangles.
  Occlusion(const Mesh& mesh, double reach);

  // The occlusion of a position on triangle number `triangle`: 0 in the open to 1. Closer surfaces count
  // more.
  double at(std::size_t triangle, const math::Vec3d& position, const math::Vec3d& normal) const;

 private:
  // A triangle with its bounding sphere.
  struct Triangle {
    math::Vec3d corner, edge_a, edge_b;
    math::Vec3d middle;
    double radius;
  };

  double reach_;
  std::vector<Triangle> triangles_;
  // For each triangle: the triangles within reach.
  std::vector<std::vector<std::size_t>> near_;
  // Directions of the rays over the upper hemisphere, densest around z.
  std::vector<math::Vec3d> directions_;
};

}  // namespace temblor::artgen
