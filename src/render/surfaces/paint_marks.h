// Marks on the texels of a surface, before light falls on them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/arena.h"
#include "formats/images/palette.h"
#include "render/color/color_tables.h"
#include "render/marks.h"
#include "render/surfaces/mark_shapes.h"
#include "render/surfaces/surface_block.h"
#include "world/level.h"

namespace temblor::render {

// Shapes and inks. Made once for a palette; takes some milliseconds.
class MarkLook {
 public:
  static constexpr int kShades = 4, kOpacities = 17;

  explicit MarkLook(const ColorTables& tables);

  const MarkShapes& shapes() const { return shapes_; }
  // What shows of a palette index under a mark. A full-bright texel glows on until half of it is covered.
  std::uint8_t over(MarkKind kind, MarkTexel texel, std::uint8_t index) const;
  // Of a color; it and the result are as in ColorTables::surface_rgb.
  std::uint32_t over(MarkKind kind, MarkTexel texel, std::uint32_t under) const;

 private:
  MarkShapes shapes_;
  std::vector<std::uint8_t> indices_;  // by kind, shade, opacity, index
};

// One mark on the texels of a block: a shape that was moved, turned and stretched.
struct PlacedMark {
  MarkKind kind{};
  int variant = 0, level = 0;
  std::int32_t left = 0, right = 0, top = 0,
               bottom = 0;  // texels of the block that it may cover; ends excluded
  // Position in the shape, -1 to 1, at the middle of texel (x, y): u = u_first + x * u_a_column + y *
  // u_a_row.
  float u_first = 0, u_a_column = 0, u_a_row = 0;
  float v_first = 0, v_a_column = 0, v_a_row = 0;
};

// Those of a face's marks that touch one tile at a mip level, in their order.
std::span<const PlacedMark> place_marks(const world::Level& level, const world::Face& face,
                                        std::span<const Mark> marks, int tile_s, int tile_t, int mip,
                                        SurfaceShape shape, base::Arena& arena);

// Paints row `y` of the block. Texels are palette indices, or as ColorTables::surface_rgb.
template <typename Texel>
void paint_marks(const MarkLook& look, std::span<const PlacedMark> marks, std::int32_t y,
                 std::span<Texel> io_row);

}  // namespace temblor::render
