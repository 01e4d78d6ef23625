// Inner loops over a row of a sprite, as vector code and as plain C++ with the same results, bit for bit.
// Only plain types here: the vector file is compiled for several processors.
#pragma once

#include <cstdint>

namespace temblor::render {

// Nearness never reaches zero on what is in view; rounding may bring it there.
constexpr float kSpriteFarthest = 1e-20f;
constexpr std::uint8_t kClearTexel = 255;

// A linear function along a row: pixel i has base + (first + i) * step.
struct SpriteLine {
  float base, step;
};

// Pixels that a sprite covers in a row of the picture. A pixel changes where `depth` is as near as what is
// there or nearer, and the texel is not kClearTexel; it takes the texel's index or color, and the depth.
struct SpriteRow {
  SpriteLine depth, s, t;       // as FrameBuffer::depth; texels, cut off at the picture's edges
  bool affine;                  // else s and t are still to be divided by depth
  const std::uint8_t* texels;   // rows follow one another
  std::int32_t width, height;   // at least 1 and at most 2^12
  const std::uint32_t* colors;  // of each texel, as stored; u32 only
  void* pixels;                 // the row's first: bytes or 32-bit colors
  float* frame_depth;
  std::int32_t first, count;  // pixels; `first` of them lie before these in the sprite's row
};

void draw_sprite_row_u8_scalar(const SpriteRow& row);
void draw_sprite_row_u32_scalar(const SpriteRow& row);
void draw_sprite_row_u8_simd(const SpriteRow& row);
void draw_sprite_row_u32_simd(const SpriteRow& row);

}  // namespace temblor::render
