#include "lab/models/sprite_kernels.h"

namespace temblor::lab {

namespace {

template <typename Pixel>
void draw_sprite(const SpriteRows& rows) {
  for (std::int32_t y = 0; y < rows.height; ++y) {
    const Pixel* const from = static_cast<const Pixel*>(rows.pixels) + y * rows.stride;
    const float* const depth = rows.depth + y * rows.stride;
    Pixel* const to = static_cast<Pixel*>(rows.out_pixels) + y * rows.out_stride;
    float* const nearest = rows.out_depth + y * rows.out_stride;
    for (std::int32_t x = 0; x < rows.width; ++x) {
      const float moved = depth[x] * rows.depth_scale;
      if (!(moved >= nearest[x])) continue;
      nearest[x] = moved;
      to[x] = from[x];
    }
  }
}

}  // namespace

void draw_sprite_u8_scalar(const SpriteRows& rows) {
  draw_sprite<std::uint8_t>(rows);
}
void draw_sprite_u32_scalar(const SpriteRows& rows) {
  draw_sprite<std::uint32_t>(rows);
}

}  // namespace temblor::lab
