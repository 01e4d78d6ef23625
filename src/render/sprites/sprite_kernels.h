// Inner loops over a row of a sprite, as SIMD and as the scalar reference with the same results, bit for bit.
// This header has plain types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstdint>

namespace temblor::render {

// 1/z is positive on visible sprites, but rounding may bring it to 0: divisions use at least this.
constexpr float kMinSpriteDepth = 1e-20f;
constexpr std::uint8_t kClearTexel = 255;

// A linear function along a row: base + (first + i) * step at pixel i.
struct SpriteLine {
  float base, step;
};

// The pixels that a sprite covers in a row of the picture. A pixel is drawn if `depth` is at least as near as
// what is there and the texel is not kClearTexel; then its color and depth are written.
struct SpriteRow {
  SpriteLine depth, s, t;       // depth as in FrameBuffer; s and t in texels, clamped to the picture
  bool affine;                  // false: s and t must still be divided by depth
  const std::uint8_t* texels;   // rows follow one another
  std::int32_t width, height;   // of the texels: 1 to 2^12
  const std::uint32_t* colors;  // by texel, in the frame's format; u32 only
  void* pixels;                 // the first pixel to draw: bytes or 32-bit colors
  float* frame_depth;           // the depth of that pixel
  std::int32_t first, count;  // the number of pixels before this one in the sprite's row, and pixels to draw
};

void draw_sprite_row_u8_scalar(const SpriteRow& row);
void draw_sprite_row_u32_scalar(const SpriteRow& row);
void draw_sprite_row_u8_simd(const SpriteRow& row);
void draw_sprite_row_u32_simd(const SpriteRow& row);

}  // namespace temblor::render
