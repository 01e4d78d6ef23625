// Hot loop.
#include <bit>

#include "render/colour/fog_kernels.h"

namespace temblor::render {

namespace {

// 0 to 1.
float share_at(const FogRow& row, float depth) {
  const float z = row.perspective ? 1.0f / (depth > kFarthestInFog ? depth : kFarthestInFog) : -depth;
  const float thickness = row.rate * z;
  const float squared = thickness * thickness;
  const float turns = (squared < kMostFog ? squared : kMostFog) * kLog2E;
  const auto whole = static_cast<std::int32_t>(turns);  // rounded down: not negative
  const float r = turns - static_cast<float>(whole);
  float series = kExpSeries[4];
  for (int i = 3; i >= 0; --i) series = series * r + kExpSeries[i];
  const auto exponent = static_cast<std::uint32_t>(127 - whole) << 23;
  return 1.0f - (series * r + 1.0f) * std::bit_cast<float>(exponent);
}

// In `steps`ths, a power of two up to 256.
std::int32_t steps_at(const FogRow& row, std::int32_t i, std::int32_t steps) {
  if (row.depth[i] == row.sky + static_cast<float>(i) * row.sky_step) return row.sky_share * steps / 256;
  return static_cast<std::int32_t>(share_at(row, row.depth[i]) * static_cast<float>(steps) + 0.5f);
}

}  // namespace

void fog_row_u8_plain(const FogRow& row) {
  auto* const pixels = static_cast<std::uint8_t*>(row.pixels);
  for (std::int32_t i = 0; i < row.count; ++i) pixels[i] = row.rows[steps_at(row, i, 64) * 256 + pixels[i]];
}

void fog_row_u32_plain(const FogRow& row) {
  auto* const pixels = static_cast<std::uint32_t*>(row.pixels);
  for (std::int32_t i = 0; i < row.count; ++i) {
    const auto fog = static_cast<std::uint32_t>(steps_at(row, i, 256));
    std::uint32_t out = pixels[i] & 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8)
      out |= (((row.colour >> shift & 255) * fog + (pixels[i] >> shift & 255) * (256 - fog) + 128) >> 8)
             << shift;
    pixels[i] = out;
  }
}

}  // namespace temblor::render
