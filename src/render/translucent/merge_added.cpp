// Hot loop of additive faces.
#include "render/translucent/merge_added.h"

#include "render/color/blend_tables.h"

namespace temblor::render {

namespace {

template <typename Texel, typename Add>
void merge_added(const MergeRow& row, Texel clear, Add add) {
  const auto* const texels = static_cast<const Texel*>(row.texels);
  auto* const pixels = static_cast<Texel*>(row.pixels);
  for (std::int32_t i = 0; i < row.count; ++i) {
    const bool is_clear = row.has_holes && texels[i] == clear;
    if (row.depth[i] * row.nearer >= row.z[i] && !is_clear) pixels[i] = add(texels[i], pixels[i]);
  }
}

}  // namespace

void merge_added_u32(const MergeRow& row) {
  merge_added(row, std::uint32_t{0}, [&](std::uint32_t texel, std::uint32_t pixel) {
    return add_rgb(blend_rgb(texel, 0, row.opacity_256), pixel);
  });
}

void merge_added_u8(const MergeRow& row, const std::uint8_t* dims) {
  merge_added(row, std::uint8_t{255}, [&](std::uint8_t texel, std::uint8_t pixel) {
    const std::uint8_t dimmed = dims != nullptr ? dims[texel * 256] : texel;
    return row.table[dimmed * 256 + pixel];
  });
}

}  // namespace temblor::render
