// The scalar reference: it defines the results of the sprite kernels.
#include <algorithm>
#include <cstddef>

#include "render/sprites/sprite_kernels.h"

namespace temblor::render {

namespace {

float at(const SpriteLine& line, int i) {
  return line.base + static_cast<float>(i) * line.step;
}

std::int32_t texel_number(float coordinate, std::int32_t size) {
  return static_cast<std::int32_t>(std::min(std::max(coordinate, 0.0f), static_cast<float>(size - 1)));
}

void put(const SpriteRow&, std::uint8_t texel, std::uint8_t& out_pixel) {
  out_pixel = texel;
}
void put(const SpriteRow& row, std::uint8_t texel, std::uint32_t& out_pixel) {
  out_pixel = row.colors[texel];
}

template <typename Pixel>
void draw_row(const SpriteRow& row) {
  Pixel* const pixels = static_cast<Pixel*>(row.pixels);
  for (int i = 0; i < row.count; ++i) {
    const int place = row.first + i;
    const float depth = at(row.depth, place);
    if (!(depth >= row.frame_depth[i])) continue;
    const float distance = row.affine ? 1.0f : 1.0f / std::max(depth, kMinSpriteDepth);
    const std::int32_t column = texel_number(at(row.s, place) * distance, row.width);
    const std::int32_t line = texel_number(at(row.t, place) * distance, row.height);
    const std::uint8_t texel = row.texels[line * row.width + column];
    if (texel == kClearTexel) continue;
    put(row, texel, pixels[i]);
    row.frame_depth[i] = depth;
  }
}

}  // namespace

void draw_sprite_row_u8_scalar(const SpriteRow& row) {
  draw_row<std::uint8_t>(row);
}
void draw_sprite_row_u32_scalar(const SpriteRow& row) {
  draw_row<std::uint32_t>(row);
}

}  // namespace temblor::render
