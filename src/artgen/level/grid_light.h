// Computes light maps for the faces of a grid: point lights with shadows. Like the stock light tool, a light
// fades linearly with distance, and half of it does not depend on the angle to the surface.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "artgen/level/grid.h"
#include "artgen/level/grid_faces.h"
#include "artgen/level/layout.h"

namespace temblor::artgen {

// How a texture lies on a face: s grows along the world axis `s_axis`, t against `t_axis`, both with
// `texels_per_unit`.
struct TextureProjection {
  std::size_t s_axis, t_axis;
  float texels_per_unit;
};
// Floors and ceilings use the x and y axes; walls use the horizontal axis in their plane and z.
TextureProjection make_projection(const GridFace& face, float texels_per_unit);

// A face's light samples, as the BSP format orders them.
struct FaceLight {
  // 255: the slot is unused. Used slots come first.
  std::array<std::uint8_t, 4> styles;
  // The samples of each used style after one another, row by row, three bytes per sample.
  std::vector<std::uint8_t> rgb;
};

// Lights faces from a layout's lights. Cells of the grid block light.
class GridLighter {
 public:
  // Keeps references to both arguments.
  GridLighter(const SmallLevelLayout& layout, const CellGrid& grid);

  // `face` belongs to `face_grid`, which may differ from the grid that casts shadows (the door's faces, for
  // example). If more than four styles reach the face, those with the highest numbers are dropped.
  FaceLight light_face(const CellGrid& face_grid, const GridFace& face,
                       const TextureProjection& projection) const;

 private:
  bool is_blocked(const math::Vec3& from, const math::Vec3& to) const;
  math::Vec3 compute_light(const LayoutLight& light, const math::Vec3& position,
                           const math::Vec3& normal) const;

  const SmallLevelLayout& layout_;
  const CellGrid& grid_;
  // Tables, because the shadow rays look up cells often. For each axis, and each whole unit from the grid's
  // first line: the index of the cell that contains it, among the first cells of the other axes. The sum of
  // three is the index of the cell that contains a point.
  std::array<std::vector<std::size_t>, 3> index_by_unit_;
  std::vector<std::uint8_t> is_solid_;  // for each cell
};

}  // namespace temblor::artgen
