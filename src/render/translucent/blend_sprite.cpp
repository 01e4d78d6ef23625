#include "render/translucent/blend_sprite.h"

#include <algorithm>
#include <array>

#include "render/sprites/sprite_rows.h"
#include "render/translucent/merge_kernels.h"

namespace temblor::render {

namespace {

void merge_row(const MergeRow& row, const std::uint8_t*, bool simd_kernels) {
  simd_kernels ? merge_blend_u8_simd(row) : merge_blend_u8_scalar(row);
}
void merge_row(const MergeRow& row, const std::uint32_t*, bool simd_kernels) {
  simd_kernels ? merge_blend_u32_simd(row) : merge_blend_u32_scalar(row);
}

// Draws the row into a buffer, a part at a time, and blends it from there:
//
//   sprite kernel (depth test, clear texels) -> texels, depth -> fog -> merge kernel -> frame
template <typename Pixel>
void blend_row(SpriteRow row, const SpriteBlend& blend, bool simd_kernels, float* frame_depth,
               Pixel* io_pixels) {
  constexpr int kPartPixels = 256;
  constexpr Pixel kClear = sizeof(Pixel) == 1 ? kClearTexel : 0;
  std::array<Pixel, kPartPixels> texels;
  std::array<float, kPartPixels> depth;
  row.pixels = texels.data();
  row.frame_depth = depth.data();
  MergeRow merged{};
  merged.texels = texels.data();
  merged.depth = depth.data();
  merged.nearer = 1;
  merged.has_holes = true;
  merged.table = blend.table;
  merged.opacity_256 = blend.opacity_256;
  const int end = row.count;
  for (; row.first < end; row.first += kPartPixels) {
    row.count = merged.count = std::min(kPartPixels, end - row.first);
    merged.z = frame_depth + row.first;
    merged.pixels = io_pixels + row.first;
    std::copy_n(merged.z, row.count, depth.data());
    std::fill_n(texels.data(), row.count, kClear);
    draw_sprite_row(row, io_pixels, simd_kernels);
    if (blend.fog != nullptr)
      blend.fog->apply(texels.data(), std::span(depth).first(static_cast<std::size_t>(row.count)));
    merge_row(merged, io_pixels, simd_kernels);
  }
}

}  // namespace

void blend_sprite(const SpriteQuad& quad, const SpriteBlend& blend, const ColorTables& tables,
                  bool simd_kernels, RowRange rows, FrameBuffer& io_frame) {
  const int end = std::min(quad.end_row, rows.end);
  for (int y = std::max(quad.first_row, rows.first); y < end; ++y) {
    const std::optional<PlacedSpriteRow> placed = place_sprite_row(quad, tables, y, io_frame.width());
    if (!placed) continue;
    float* const depth = io_frame.depth().data() + placed->first_pixel;
    if (io_frame.format() == PixelFormat::kIndexed)
      blend_row(placed->row, blend, simd_kernels, depth, io_frame.indexed().data() + placed->first_pixel);
    else
      blend_row(placed->row, blend, simd_kernels, depth, io_frame.rgb().data() + placed->first_pixel);
  }
}

}  // namespace temblor::render
