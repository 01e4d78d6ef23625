// Hot loop. The scalar reference of the merge kernels.
#include "render/translucent/merge_kernels.h"

namespace temblor::render {

namespace {

bool is_clear(std::uint8_t texel) {
  return texel == 255;
}
bool is_clear(std::uint32_t texel) {
  return texel >> 24 == 0;
}

// Calls put(i, texel) for each pixel that shows.
template <typename Texel, typename Put>
void for_each_shown(const MergeRow& row, std::int32_t first, Put put) {
  const auto* const texels = static_cast<const Texel*>(row.texels);
  for (std::int32_t i = first; i < row.count; ++i) {
    if (!(row.depth[i] * row.nearer >= row.z[i])) continue;
    if (row.has_holes && is_clear(texels[i])) continue;
    put(i, texels[i]);
  }
}

template <typename Texel>
void merge_opaque(const MergeRow& row, std::int32_t first) {
  for_each_shown<Texel>(row, first, [&](std::int32_t i, Texel texel) {
    static_cast<Texel*>(row.pixels)[i] = texel;
    row.z[i] = row.depth[i];
  });
}

}  // namespace

void merge_opaque_u8_scalar(const MergeRow& row, std::int32_t first) {
  merge_opaque<std::uint8_t>(row, first);
}
void merge_opaque_u32_scalar(const MergeRow& row, std::int32_t first) {
  merge_opaque<std::uint32_t>(row, first);
}

void merge_blend_u8_scalar(const MergeRow& row, std::int32_t first) {
  auto* const pixels = static_cast<std::uint8_t*>(row.pixels);
  for_each_shown<std::uint8_t>(row, first, [&](std::int32_t i, std::uint8_t texel) {
    pixels[i] = row.table[texel * 256 + pixels[i]];
  });
}

void merge_blend_u32_scalar(const MergeRow& row, std::int32_t first) {
  auto* const pixels = static_cast<std::uint32_t*>(row.pixels);
  const auto over = static_cast<std::uint32_t>(row.opacity_256), under = 256 - over;
  for_each_shown<std::uint32_t>(row, first, [&](std::int32_t i, std::uint32_t texel) {
    std::uint32_t out = 0xff000000u;
    for (int shift = 0; shift < 24; shift += 8)
      out |= (((texel >> shift & 255) * over + (pixels[i] >> shift & 255) * under + 128) >> 8) << shift;
    pixels[i] = out;
  });
}

}  // namespace temblor::render
