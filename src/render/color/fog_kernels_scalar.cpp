// Hot loop. The scalar reference of the fog kernels.
#include <bit>

#include "render/color/fog_kernels.h"

namespace temblor::render {

namespace {

bool is_sky(const FogRow& row, std::int32_t i) {
  return row.has_sky && row.depth[i] == row.sky + static_cast<float>(i) * row.sky_step;
}

std::uint32_t share_256(const FogRow& row, float depth) {
  float x = row.perspective ? depth * row.inverse_rate
                            : row.inverse_rate / (depth < -kMinDistance ? -depth : kMinDistance);
  x = x < kMaxNearness ? x : kMaxNearness;
  x = x > kMinNearness ? x : kMinNearness;
  const std::uint32_t piece = std::bit_cast<std::uint32_t>(x) >> 22 & (kFogPieces - 1);
  float share = row.curve->cubic[3][piece];
  for (int power = 2; power >= 0; --power) share = share * x + row.curve->cubic[power][piece];
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(share));
}

}  // namespace

// A binary search without branches; step_end_depths is in descending order.
int fog_step_at(const float* step_end_depths, float depth) {
  int step = 0;
  for (int half = kFogSteps / 2; half > 0; half /= 2) step += depth < step_end_depths[step + half] ? half : 0;
  return step + (depth < step_end_depths[step + 1] ? 1 : 0);
}

void fog_row_u8_scalar(const FogRow& row) {
  fog_pixels_u8_scalar(row, 0, row.count);
}

// Neighboring pixels usually share a step: then a pixel costs only its table lookup.
void fog_pixels_u8_scalar(const FogRow& row, std::int32_t first, std::int32_t end) {
  auto* const pixels = static_cast<std::uint8_t*>(row.pixels);
  int step = 0;
  for (std::int32_t i = first; i < end; ++i) {
    if (is_sky(row, i)) {
      pixels[i] = row.rows[row.sky_share * kFogSteps / 256 * 256 + pixels[i]];
      continue;
    }
    if (!(row.depth[i] < row.step_end_depths[step] && row.depth[i] >= row.step_end_depths[step + 1]))
      step = fog_step_at(row.step_end_depths, row.depth[i]);
    pixels[i] = row.rows[step * 256 + pixels[i]];
  }
}

void fog_row_u32_scalar(const FogRow& row) {
  auto* const pixels = static_cast<std::uint32_t*>(row.pixels);
  for (std::int32_t i = 0; i < row.count; ++i) {
    const std::uint32_t fog =
        is_sky(row, i) ? static_cast<std::uint32_t>(row.sky_share) : share_256(row, row.depth[i]);
    std::uint32_t out = pixels[i] & 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8)
      out |= (((row.color >> shift & 255) * fog + (pixels[i] >> shift & 255) * (256 - fog) + 128) >> 8)
             << shift;
    pixels[i] = out;
  }
}

}  // namespace temblor::render
