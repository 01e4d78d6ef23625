// Merges a row of a deferred face or translucent model, which was drawn into a buffer, into the picture where
// it is in front. The SIMD version and the scalar reference have the same results, bit for bit. It has plain
// types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstdint>

namespace temblor::render {

// `count` pixels of a row. A pixel is drawn if depth * nearer >= z and its texel is not clear. Fog gives
// clear colors a hue, but their alpha stays 0.
struct MergeRow {
  const void* texels;  // bytes (255: clear) or 0xffRRGGBB (0x00RRGGBB: clear)
  const float* depth;  // of the texels
  void* pixels;        // of the frame, which are changed
  float* z;            // the depth of those pixels
  std::int32_t count;
  float nearer;    // a factor near 1, by which a face at equal depth wins
  bool has_holes;  // false: no texel is clear
  // Blending only.
  const std::uint8_t* table;  // bytes: BlendTables
  std::int32_t opacity_256;   // 0xffRRGGBB: 0 to 256, as blend_rgb has it
};

// Opaque: write pixels and z. The scalar versions begin at pixel `first`, so that they can finish what SIMD
// leaves.
void merge_opaque_u8_scalar(const MergeRow& row, std::int32_t first = 0);
void merge_opaque_u32_scalar(const MergeRow& row, std::int32_t first = 0);
// Blending: write only pixels, since translucent things hide nothing.
void merge_blend_u8_scalar(const MergeRow& row, std::int32_t first = 0);
void merge_blend_u32_scalar(const MergeRow& row, std::int32_t first = 0);

void merge_opaque_u8_simd(const MergeRow& row);
void merge_opaque_u32_simd(const MergeRow& row);
void merge_blend_u8_simd(const MergeRow& row);
void merge_blend_u32_simd(const MergeRow& row);

}  // namespace temblor::render
