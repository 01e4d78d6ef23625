// Part of a row of a late face, drawn by itself, goes into the picture where it is in front. Vector code and
// plain C++ with the same results, bit for bit. Only plain types here: the vector file is compiled for
// several processors.
#pragma once

#include <cstdint>

namespace temblor::render {

// `count` pixels. A pixel of the face shows where depth * nearer >= its z, and its texel is not clear.
struct MergeRow {
  const void* texels;  // bytes (255: clear, if anything is), or 0xffRRGGBB (0: clear)
  const float* depth;
  void* pixels;
  float* z;
  std::int32_t count;
  float nearer;
  bool has_holes;
  // Blending only.
  const std::uint8_t* table;  // bytes: BlendTables
  std::int32_t opacity_256;   // 0xffRRGGBB: 0 to 256, as blend_rgb has it
};

// From pixel `first` on. Writes pixels and z.
void merge_opaque_u8_scalar(const MergeRow& row, std::int32_t first = 0);
void merge_opaque_u32_scalar(const MergeRow& row, std::int32_t first = 0);
// Writes pixels: what is translucent hides nothing.
void merge_blend_u8_scalar(const MergeRow& row, std::int32_t first = 0);
void merge_blend_u32_scalar(const MergeRow& row, std::int32_t first = 0);

void merge_opaque_u8_simd(const MergeRow& row);
void merge_opaque_u32_simd(const MergeRow& row);
void merge_blend_u8_simd(const MergeRow& row);
void merge_blend_u32_simd(const MergeRow& row);

}  // namespace temblor::render
