// Hot loop.
#include <algorithm>

#include "lab/world_light/effects/pattern_kernels.h"

namespace temblor::lab {

namespace {

std::int32_t find_pattern(const PatternRow& row, std::int32_t x) {
  std::int32_t sum = 0;
  for (const OctaveRow& octave : row.octaves) {
    const std::int32_t at = octave.first + x;
    const std::int32_t* const node = octave.nodes + (at >> octave.shift);
    const std::int32_t fraction = at & ((1 << octave.shift) - 1);
    sum += node[0] + ((node[1] - node[0]) * fraction >> octave.shift);
  }
  return std::clamp((sum >> 7) + ((row.bias_first + x * row.bias_step) >> 12), 0, 255);
}

std::uint32_t change_channel(std::uint32_t color, std::uint32_t ink, int shift) {
  const std::uint32_t kept = (color >> shift & 255) * ((ink >> 24) + 1) >> 8;
  return std::min(kept + (ink >> shift & 255), 255u) << shift;
}

}  // namespace

void change_row_u8_scalar(const PatternRow& row, std::uint8_t* io_texels) {
  for (std::int32_t x = 0; x < row.count; ++x) {
    const std::int32_t pattern = find_pattern(row, x) * kIndexedPatterns / 256;
    if (io_texels[x] != row.clear) io_texels[x] = row.indices[pattern * 256 + io_texels[x]];
  }
}

void change_row_u32_scalar(const PatternRow& row, std::uint32_t* io_texels) {
  for (std::int32_t x = 0; x < row.count; ++x) {
    const std::uint32_t color = io_texels[x];
    if (color >> 24 == 0) continue;
    const std::uint32_t ink = row.inks[find_pattern(row, x)];
    std::uint32_t changed = color & 0xff000000u;
    for (const int shift : {0, 8, 16}) changed |= change_channel(color, ink, shift);
    io_texels[x] = changed;
  }
}

}  // namespace temblor::lab
