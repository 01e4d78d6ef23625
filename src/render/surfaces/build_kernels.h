// Inner loops of build_surface: one row of a surface block, as SIMD and as the scalar reference with the same
// results, bit for bit. This header has plain types only, because the SIMD file is compiled for several
// processors.
//
// Along a row, light is interpolated between sample columns that are `texels_per_sample` (16, 8, 4, or 2 for
// mip 0 to 3; 1 to 16 for light maps of other resolutions) texels apart:
//
//   light     L0              L1              L2
//   texels    t t t t t t t t t t t t t t t t t
//
// The SIMD kernels may read 32 texels past the end of the row.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

struct IndexedRow {
  const std::uint8_t* texels;    // `count` palette indices
  const std::int16_t* light;     // (65280 - sum) >> 2 by sample column: one more than begin within the row
  const std::uint8_t* colormap;  // 64 rows of 256
  std::uint8_t* out;
  std::int32_t count, texels_per_sample;
};
struct RgbRow {
  const std::uint32_t* texels;  // `count` colors, 0xffRRGGBB; alpha 0: full-bright, not lit
  const std::int16_t* light;    // blue, green, red, 0 by sample column: half the sum
  std::uint32_t* out;
  std::int32_t count, texels_per_sample;
};

void build_indexed_row_scalar(const IndexedRow& row);
void build_rgb_row_scalar(const RgbRow& row);
void build_indexed_row_simd(const IndexedRow& row);
void build_rgb_row_simd(const RgbRow& row);

}  // namespace temblor::render
