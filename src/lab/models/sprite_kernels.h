// Inner loops that draw the cached picture of a model, tested against depth, as SIMD and as the scalar
// reference with the same results, bit for bit. This header has plain types only, because the SIMD file is
// compiled for several processors.
#pragma once

#include <cstdint>

namespace temblor::lab {

// Rows of pixels that are drawn over others. All pointers are to the first pixel that is drawn.
struct SpriteRows {
  const void* pixels;
  const float* depth;  // minus infinity where there is no model
  float depth_scale;   // positive
  void* out_pixels;    // of the frame
  float* out_depth;
  std::int64_t stride, out_stride;  // pixels from row to row
  std::int32_t width, height;
};

void draw_sprite_u8_scalar(const SpriteRows& rows);
void draw_sprite_u32_scalar(const SpriteRows& rows);
void draw_sprite_u8_simd(const SpriteRows& rows);
void draw_sprite_u32_simd(const SpriteRows& rows);

}  // namespace temblor::lab
