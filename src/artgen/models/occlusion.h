// How much of a surface's surroundings is hidden by the model itself: what makes creases dark.
#pragma once

#include <cstddef>
#include <vector>

#include "artgen/models/mesh.h"
#include "math/vec.h"

namespace temblor::artgen {

class Occlusion {
 public:
  // At rest. What is farther than `reach` hides nothing.
  Occlusion(const Mesh& mesh, double reach);

  // 0 in the open to 1, for a place on triangle number `triangle`.
  double at(std::size_t triangle, const math::Vec3d& place, const math::Vec3d& normal) const;

 private:
  struct Triangle {
    math::Vec3d corner, edge_a, edge_b;
    math::Vec3d middle;
    double radius;
  };

  double reach_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::size_t>> near_;  // by triangle: those within reach
  std::vector<math::Vec3d> ways_;               // over the upper half of a ball, dense at its top
};

}  // namespace temblor::artgen
