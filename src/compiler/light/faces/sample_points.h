// Where the light of a face is measured: the grid of its light map, laid on its plane and kept in the open.
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

// The luxels of a light map: column c, row r at origin_world + c * column_step + r * row_step, in its plane.
struct LightGrid {
  std::size_t face = 0, map = 0;
  int width = 0, height = 0;
  math::Vec3d normal{0.0};
  math::Vec3d origin_world{0.0}, column_step{0.0}, row_step{0.0};
  std::vector<math::Vec3d> corners_world;
  math::Vec3d middle_world{0.0};  // of the corners

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

// A face whose texture axes span no plane has all of its luxels in its middle.
LightGrid make_light_grid(const LitLevel& lit, std::size_t map);

struct SamplePlaces {
  std::vector<math::Vec3> points;
  std::vector<world::LeafIndex> leaves;  // leaf 0: within something solid, with nothing open to be found near

  bool is_hidden(std::size_t i) const { return leaves[i] == world::LeafIndex{0}; }
};

// The open place for every sample of the grid, `per_luxel` each way, row by row; a luxel stands for the
// square around it, one step wide. A place lies a unit before the face. Where the grid sticks out of the
// face, the place is the grid's own as far as one can go there from the face without meeting anything: so
// neighbors in one plane measure the same light along their seam, and nothing is measured beyond a wall.
SamplePlaces sample_points(const LitLevel& lit, const RayScene& scene, const LightGrid& grid, int per_luxel);
// One sample each of some luxels, by number.
SamplePlaces places_of_luxels(const LitLevel& lit, const RayScene& scene, const LightGrid& grid,
                              std::span<const std::uint32_t> luxels);

}  // namespace temblor::compiler
