#include "render/sprites/sprite_rows.h"

#include <algorithm>
#include <cmath>

namespace temblor::render {

namespace {

struct PixelRange {
  int first, end;
};

// The pixels of a row whose centers the outline covers.
PixelRange find_row_pixels(const SpriteOutline& outline, int row, int width) {
  double left = width, right = 0;
  for (std::size_t i = 0; i < outline.count; ++i) {
    const math::Vec2d &from = outline.corners[i], &to = outline.corners[(i + 1) % outline.count];
    if ((from.y <= row) == (to.y <= row)) continue;
    const double x = from.x + (row - from.y) * ((to.x - from.x) / (to.y - from.y));
    left = std::min(left, x);
    right = std::max(right, x);
  }
  return {static_cast<int>(std::ceil(std::max(left, 0.0))),
          static_cast<int>(std::ceil(std::min<double>(right, width)))};
}

SpriteLine line_along(const ScreenPlane& plane, int x, int y) {
  return {static_cast<float>(plane.at(x, y)), static_cast<float>(plane.dx)};
}

}  // namespace

std::optional<PlacedSpriteRow> place_sprite_row(const SpriteQuad& quad, const ColorTables& tables, int y,
                                                int frame_width) {
  const PixelRange range = find_row_pixels(quad.outline, y, frame_width);
  if (range.first >= range.end) return std::nullopt;
  const formats::SprPicture& picture = *quad.picture;
  SpriteRow row{};
  row.depth = line_along(quad.depth, range.first, y);
  row.s = line_along(quad.s, range.first, y);
  row.t = line_along(quad.t, range.first, y);
  row.affine = quad.affine;
  row.texels = picture.texels.data();
  row.width = static_cast<std::int32_t>(picture.width);
  row.height = static_cast<std::int32_t>(picture.height);
  row.colors = tables.rgb.data();
  row.count = range.end - range.first;
  return PlacedSpriteRow{row, static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_width) +
                                  static_cast<std::size_t>(range.first)};
}

void draw_sprite_row(const SpriteRow& row, const std::uint8_t*, bool simd_kernels) {
  simd_kernels ? draw_sprite_row_u8_simd(row) : draw_sprite_row_u8_scalar(row);
}
void draw_sprite_row(const SpriteRow& row, const std::uint32_t*, bool simd_kernels) {
  simd_kernels ? draw_sprite_row_u32_simd(row) : draw_sprite_row_u32_scalar(row);
}

}  // namespace temblor::render
