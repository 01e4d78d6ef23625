// Inner loops of fog, as SIMD and as the scalar reference with the same results, bit for bit. This header has
// plain types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstdint>

#include "render/color/fog_curve.h"

namespace temblor::render {

// In parallel projection, pixels beside or behind the eye are drawn too: their distance is clamped to this.
constexpr float kMinDistance = 1e-12f;

// `count` pixels of one row.
struct FogRow {
  void* pixels;        // bytes or 0xAARRGGBB; A stays
  const float* depth;  // ViewFrame::depth
  std::int32_t count;
  bool perspective;    // depth is 1/z; else -z
  float inverse_rate;  // units
  // Pixel i is sky if `has_sky` and its depth is exactly sky + i * sky_step: it gets `sky_share` 256ths of
  // fog.
  bool has_sky;
  float sky, sky_step;
  std::int32_t sky_share;
  std::uint32_t color;           // rgb
  const FogCurve* curve;         // rgb
  const std::uint8_t* rows;      // indexed: FogTables
  const float* step_end_depths;  // indexed: FogCurve::step_ends, but of depths
  // Indexed: the same steps; null in parallel projection and for densities that FogCells cannot number.
  const FogCells* cells;
};

// The share of fog at a depth, in 64ths.
int fog_step_at(const float* step_end_depths, float depth);

void fog_row_u8_scalar(const FogRow& row);
void fog_pixels_u8_scalar(const FogRow& row, std::int32_t first, std::int32_t end);  // a part of the row
void fog_row_u32_scalar(const FogRow& row);
void fog_row_u8_simd(const FogRow& row);
void fog_row_u32_simd(const FogRow& row);

}  // namespace temblor::render
