// Inner loops of fog, as vector code and as plain C++ with the same results, bit for bit. Only plain types
// here: the vector file is compiled for several processors.
#pragma once

#include <cstdint>

#include "render/color/fog_curve.h"

namespace temblor::render {

// Without perspective what lies beside or behind the eye is drawn too.
constexpr float kMinDistance = 1e-12f;

// `count` pixels of one row.
struct FogRow {
  void* pixels;        // bytes or 0xAARRGGBB; A stays
  const float* depth;  // ViewFrame::depth
  std::int32_t count;
  bool perspective;    // depth is 1/z; else -z
  float inverse_rate;  // units
  // Where pixel i has exactly the depth sky + i * sky_step, sky is seen: it gets `sky_share` 256ths. Without
  // `has_sky` there is none.
  bool has_sky;
  float sky, sky_step;
  std::int32_t sky_share;
  std::uint32_t color;           // rgb
  const FogCurve* curve;         // rgb
  const std::uint8_t* rows;      // indexed: FogTables
  const float* step_end_depths;  // indexed: FogCurve::step_ends, but of depths
};

// How many 64ths of fog lie before a depth.
int fog_step_at(const float* step_end_depths, float depth);

void fog_row_u8_scalar(const FogRow& row);
void fog_row_u32_scalar(const FogRow& row);
void fog_row_u8_simd(const FogRow& row);
void fog_row_u32_simd(const FogRow& row);

}  // namespace temblor::render
