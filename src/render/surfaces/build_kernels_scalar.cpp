#include "render/surfaces/build_kernels.h"

namespace temblor::render {

namespace {

// (a * b + 2^14) >> 15, the operation of one SIMD instruction (pmulhrsw).
constexpr std::int32_t multiply_q15(std::int32_t a, std::int32_t b) {
  return (a * b + 16384) >> 15;
}

constexpr std::uint32_t lit_channel(std::uint32_t color, std::int32_t half_light) {
  const std::int32_t lit = multiply_q15(static_cast<std::int32_t>(2 * color), half_light);
  return static_cast<std::uint32_t>(lit > 255 ? 255 : lit);
}

}  // namespace

// Light is in units of a colormap row times 256, so its high byte selects the row.
void build_indexed_row_scalar(const IndexedRow& row) {
  const std::int32_t fraction_per_texel = 32768 / row.texels_per_sample;
  for (std::int32_t x = 0; x < row.count; ++x) {
    const std::int16_t* sample = row.light + x / row.texels_per_sample;
    const std::int32_t fraction = x % row.texels_per_sample * fraction_per_texel;
    const std::int32_t light = sample[0] + multiply_q15(sample[1] - sample[0], fraction);
    row.out[x] = row.colormap[(light & ~255) + row.texels[x]];
  }
}

// Texels of alpha 0 are full-bright: they are copied and get alpha 255.
void build_rgb_row_scalar(const RgbRow& row) {
  const std::int32_t fraction_per_texel = 32768 / row.texels_per_sample;
  for (std::int32_t x = 0; x < row.count; ++x) {
    const std::uint32_t texel = row.texels[x];
    if (texel >> 24 == 0) {
      row.out[x] = texel | 0xff000000u;
      continue;
    }
    const std::int16_t* sample = row.light + x / row.texels_per_sample * 4;
    const std::int32_t fraction = x % row.texels_per_sample * fraction_per_texel;
    std::uint32_t out = 0xff000000u;
    for (int channel = 0; channel < 3; ++channel) {
      const std::int32_t light =
          sample[channel] + multiply_q15(sample[4 + channel] - sample[channel], fraction);
      out |= lit_channel(texel >> (8 * channel) & 255, light) << (8 * channel);
    }
    row.out[x] = out;
  }
}

}  // namespace temblor::render
