// Sample points: where the light of a face is measured. The grid of its light map is laid on its plane and
// moved into open space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/light/lit_level.h"
#include "compiler/light/rays/ray_scene.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

// The luxels of a light map: column c, row r is at origin_world + c * column_step + r * row_step, on the
// face's plane.
struct LightGrid {
  std::size_t face = 0, map = 0;
  int width = 0, height = 0;
  math::Vec3d normal{0.0};
  math::Vec3d origin_world{0.0}, column_step{0.0}, row_step{0.0};
  std::vector<math::Vec3d> corners_world;
  math::Vec3d middle_world{0.0};  // the mean of the corners

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// If the face's texture axes span no plane, all of its luxels are at its center.
LightGrid make_light_grid(const LitLevel& lit, std::size_t map);

// Points with the leaves that they are in.
struct SamplePoints {
  std::vector<math::Vec3> points;
  std::vector<world::LeafIndex> leaves;  // leaf 0: inside solid, with no open space nearby

  bool is_hidden(std::size_t i) const { return leaves[i] == world::LeafIndex{0}; }
};

// Returns the sample points of the grid, `per_luxel` along each axis, row by row. A luxel stands for the
// square around it, one step wide. Points are a unit in front of the face. Where the grid sticks out of the
// face, its points are used as far as they can be reached from the face without meeting anything: so
// neighbors in one plane measure the same light along their seam, and nothing is measured behind a wall.
SamplePoints sample_points(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, int per_luxel);
// Returns one sample point for each of the listed luxels.
SamplePoints sample_luxels(const LitLevel& lit, const RayScene& scene, const LightGrid& grid,
                           std::span<const std::uint32_t> luxels);

}  // namespace temblor::compiler
