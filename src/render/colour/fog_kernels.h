// Inner loops of fog, as vector code and as plain C++ with the same results, bit for bit. Only plain types
// here: the vector file is compiled for several processors.
//
// The fog's share of a pixel at distance z is 1 - exp(-(rate * z)^2), rounded to 256ths (rgb) or 64ths
// (indexed). exp(-e) is 2^-n times a power series; the share is off by less than 0.0002.
#pragma once

#include <cstdint>

namespace temblor::render {

constexpr float kLog2E = 1.44269504f;
// exp(-r ln 2), r from 0 to 1: 1 + r (c1 + r (c2 + ...)).
constexpr float kExpSeries[5] = {-0.693147181f, 0.240226507f, -0.0555041087f, 0.00961812911f,
                                 -0.00133335581f};
constexpr float kMostFog = 20.0f;         // of e: nothing is left of the pixel
constexpr float kFarthestInFog = 1e-12f;  // 1/z, where it is not positive

// `count` pixels of one row.
struct FogRow {
  void* pixels;        // bytes or 0xAARRGGBB; A stays
  const float* depth;  // ViewFrame::depth
  std::int32_t count;
  bool perspective;  // depth is 1/z; else -z
  float rate;        // 1 / units
  // Where pixel i has exactly the depth sky + i * sky_step, sky is seen: it gets `sky_share` 256ths. A `sky`
  // that is not a number: there is none.
  float sky, sky_step;
  std::int32_t sky_share;
  std::uint32_t colour;      // rgb
  const std::uint8_t* rows;  // indexed: FogTables
};

void fog_row_u8_plain(const FogRow& row);
void fog_row_u32_plain(const FogRow& row);
void fog_row_u8_vector(const FogRow& row);
void fog_row_u32_vector(const FogRow& row);

}  // namespace temblor::render
