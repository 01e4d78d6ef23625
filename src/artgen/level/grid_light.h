// Light maps for the faces of a grid: point lights that fade with distance, and shadows.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "artgen/level/grid.h"
#include "artgen/level/grid_faces.h"
#include "artgen/level/plan.h"

namespace temblor::artgen {

// Where a face's texture lies: s grows along world axis `s_axis`, t against `t_axis`, `texels_per_unit` of
// both.
struct TextureLayout {
  std::size_t s_axis, t_axis;
  float texels_per_unit;
};
TextureLayout layout_of(const GridFace& face, float texels_per_unit);

struct FaceLight {
  std::array<std::uint8_t, 4> styles;  // 255: unused
  std::vector<std::uint8_t> rgb;       // the used styles one after the other, three bytes a sample
};

class GridLighter {
 public:
  // Keeps references to both.
  GridLighter(const SmallLevelPlan& plan, const CellGrid& grid);

  FaceLight light(const CellGrid& face_grid, const GridFace& face, const TextureLayout& layout) const;

 private:
  bool blocked(const math::Vec3& from, const math::Vec3& to) const;
  math::Vec3 light_at(const PlanLight& light, const math::Vec3& position, const math::Vec3& normal) const;

  const SmallLevelPlan& plan_;
  const CellGrid& grid_;
  std::array<std::vector<std::uint16_t>, 3> cell_of_unit_;  // from the grid's first line, for each whole unit
};

}  // namespace temblor::artgen
