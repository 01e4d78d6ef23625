#include "render/sprites/draw_sprites.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "render/color/blend_tables.h"
#include "render/sprites/sprite_kernels.h"

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

// Everything about a row except its destination.
SpriteRow make_row(const SpriteQuad& quad, const ColorTables& tables, int y, PixelRange range) {
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
  return row;
}

void draw_opaque(SpriteRow row, std::size_t first_pixel, bool simd_kernels, FrameBuffer& io_frame) {
  row.frame_depth = io_frame.depth().data() + first_pixel;
  if (io_frame.format() == PixelFormat::kIndexed) {
    row.pixels = io_frame.indexed().data() + first_pixel;
    simd_kernels ? draw_sprite_row_u8_simd(row) : draw_sprite_row_u8_scalar(row);
  } else {
    row.pixels = io_frame.rgb().data() + first_pixel;
    simd_kernels ? draw_sprite_row_u32_simd(row) : draw_sprite_row_u32_scalar(row);
  }
}

// A segment of a sprite's row, drawn into a buffer: the texels that pass the depth test, and their depth.
constexpr int kSegmentPixels = 256;
struct SpriteSegment {
  std::array<std::uint8_t, kSegmentPixels> texels;
  std::array<float, kSegmentPixels> depth;
  std::size_t count;

  std::span<const float> depths() const { return std::span(depth).first(count); }
};

void blend_indexed(SpriteSegment& io_segment, const SpriteBlend& blend, std::uint8_t* io_pixels) {
  if (blend.fog != nullptr) blend.fog->apply(io_segment.texels.data(), io_segment.depths());
  for (std::size_t i = 0; i < io_segment.count; ++i)
    if (io_segment.texels[i] != kClearTexel)
      io_pixels[i] = blend.table[io_segment.texels[i] * 256 + io_pixels[i]];
}

void blend_rgb_segment(const SpriteSegment& segment, const SpriteBlend& blend, const ColorTables& tables,
                       std::uint32_t* io_pixels) {
  std::array<std::uint32_t, kSegmentPixels> colors;
  for (std::size_t i = 0; i < segment.count; ++i) colors[i] = tables.rgb[segment.texels[i]];
  if (blend.fog != nullptr) blend.fog->apply(colors.data(), segment.depths());
  for (std::size_t i = 0; i < segment.count; ++i)
    if (segment.texels[i] != kClearTexel)
      io_pixels[i] = blend_rgb(colors[i], io_pixels[i], blend.opacity_256);
}

void draw_blended(SpriteRow row, const SpriteBlend& blend, const ColorTables& tables, std::size_t first_pixel,
                  bool simd_kernels, FrameBuffer& io_frame) {
  SpriteSegment segment;
  row.pixels = segment.texels.data();
  row.frame_depth = segment.depth.data();
  const int count = row.count;
  for (row.first = 0; row.first < count; row.first += kSegmentPixels) {
    row.count = std::min(kSegmentPixels, count - row.first);
    segment.count = static_cast<std::size_t>(row.count);
    const std::size_t pixel = first_pixel + static_cast<std::size_t>(row.first);
    std::copy_n(io_frame.depth().data() + pixel, segment.count, segment.depth.data());
    std::fill_n(segment.texels.data(), segment.count, kClearTexel);
    simd_kernels ? draw_sprite_row_u8_simd(row) : draw_sprite_row_u8_scalar(row);
    if (io_frame.format() == PixelFormat::kIndexed)
      blend_indexed(segment, blend, io_frame.indexed().data() + pixel);
    else
      blend_rgb_segment(segment, blend, tables, io_frame.rgb().data() + pixel);
  }
}

}  // namespace

void draw_sprite_instance(const SpriteQuad& quad, const SpriteBlend& blend, const ColorTables& tables,
                          bool simd_kernels, RowRange rows, FrameBuffer& io_frame) {
  const bool opaque = blend.is_opaque(io_frame.format());
  const int end = std::min(quad.end_row, rows.end);
  for (int y = std::max(quad.first_row, rows.first); y < end; ++y) {
    const PixelRange range = find_row_pixels(quad.outline, y, io_frame.width());
    if (range.first >= range.end) continue;
    const SpriteRow row = make_row(quad, tables, y, range);
    const std::size_t first_pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(io_frame.width()) +
                                    static_cast<std::size_t>(range.first);
    if (opaque)
      draw_opaque(row, first_pixel, simd_kernels, io_frame);
    else
      draw_blended(row, blend, tables, first_pixel, simd_kernels, io_frame);
  }
}

std::span<const SpriteQuad> place_sprites(const Scene& scene, const ViewFrame& view, base::Arena& arena) {
  base::ArenaVector<SpriteQuad> quads(arena, scene.sprites.size());
  for (const SpriteInstance& sprite : scene.sprites) {
    if (sprite.alpha < 1) continue;
    if (const std::optional<SpriteQuad> quad = make_sprite_quad(view, sprite)) quads.push_back(*quad);
  }
  return quads.view();
}

void draw_sprites(std::span<const SpriteQuad> quads, const ColorTables& tables, bool simd_kernels,
                  RowRange rows, FrameBuffer& io_frame) {
  for (const SpriteQuad& quad : quads) draw_sprite_instance(quad, {}, tables, simd_kernels, rows, io_frame);
}

}  // namespace temblor::render
