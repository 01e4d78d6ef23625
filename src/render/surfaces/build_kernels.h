// Rows of a lit surface: the inner loops of build_surface, as vector code and as plain C++ with the same
// results. Only plain types here: the vector file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// The vector kernels may read 32 texels past a row's end.
//
// Along one row, light is interpolated between sample columns, `texels_a_sample` (16, 8, 4 or 2) texels
// apart.
struct IndexedRow {
  const std::uint8_t* texels;    // `count` palette indices
  const std::int16_t* light;     // (65280 - sum) >> 2 by sample column: one more than begin within the row
  const std::uint8_t* colormap;  // 64 rows of 256
  std::uint8_t* out;
  std::int32_t count, texels_a_sample;
};
struct RgbRow {
  const std::uint32_t* texels;  // `count` colors, 0xffRRGGBB; alpha 0: full-bright, not lit
  const std::int16_t* light;    // blue, green, red, 0 by sample column: half the sum
  std::uint32_t* out;
  std::int32_t count, texels_a_sample;
};

void build_indexed_row_scalar(const IndexedRow& row);
void build_rgb_row_scalar(const RgbRow& row);
void build_indexed_row_simd(const IndexedRow& row);
void build_rgb_row_simd(const RgbRow& row);

}  // namespace temblor::render
