// Paints marks onto the texels of a surface block, before light is applied.
//
// Marks are placed in the plane of the face, not in texels, so that they stay round on stretched textures and
// continue across the borders of tiles.
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

// Shapes and inks as lookup tables, and the palette for pictures. Made once per palette; takes some
// milliseconds.
class MarkTables {
 public:
  static constexpr int kShades = 4, kOpacities = 17;

  explicit MarkTables(const ColorTables& tables);

  const MarkShapes& shapes() const { return shapes_; }
  // Blends a mark over a palette index. A full-bright texel keeps glowing until half of it is covered.
  std::uint8_t over(MarkKind kind, MarkTexel texel, std::uint8_t index) const;
  // Blends a mark over a color. Both colors are in the format of ColorTables::surface_rgb.
  std::uint32_t over(MarkKind kind, MarkTexel texel, std::uint32_t under) const;
  // The same for pictures.
  std::uint8_t over(const PictureTexel& texel, std::uint8_t index) const;
  std::uint32_t over(const PictureTexel& texel, std::uint32_t under) const;

 private:
  MarkShapes shapes_;
  formats::Palette palette_;
  PaletteMatch match_;
  std::vector<std::uint8_t> indices_;  // by kind, shade, opacity, index
};

// A mark on the texels of one block: a shape or picture that is moved, turned, and stretched.
struct PlacedMark {
  MarkKind kind{};
  const MarkPicture* picture = nullptr;  // only for kPicture
  int variant = 0, level = 0;
  // The texels of the block that it may cover; right and bottom are exclusive.
  std::int32_t left = 0, right = 0, top = 0, bottom = 0;
  // The position in the shape, -1 to 1, at the center of texel (x, y):
  //   u = u_first + x * u_per_column + y * u_per_row, and v likewise.
  float u_first = 0, u_per_column = 0, u_per_row = 0;
  float v_first = 0, v_per_column = 0, v_per_row = 0;
};

// The marks of a face that touch one tile at a mip level, in their order. Lives in `arena`.
std::span<const PlacedMark> place_marks(const world::Level& level, const world::Face& face,
                                        std::span<const Mark> marks, const BlockPlace& place,
                                        base::Arena& arena);

// Paints row `y` of the block. Texels are palette indices, or colors in the format of
// ColorTables::surface_rgb.
template <typename Texel>
void paint_marks(const MarkTables& look, std::span<const PlacedMark> marks, std::int32_t y,
                 std::span<Texel> io_row);

}  // namespace temblor::render
