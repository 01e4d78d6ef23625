// Inner loops that light the pixels of spans while they texture them, as SIMD and as the scalar reference
// with the same results, bit for bit. This header has plain types only, because the SIMD file is compiled for
// several processors.
//
// Texels are those of surface blocks: s and t are divided, clamped, and rounded as in SurfaceSpans. Light has
// the units of surface blocks too (render/surfaces/build_kernels.h): for bytes, 256 for each row of the
// colormap; for colors, half the sum of light, 16384 for a color as it is.
#pragma once

#include "render/spans/span_kernels.h"

namespace temblor::lab {

constexpr int kMaxChannels = 3;

// A texture that repeats. So that a window of texels may cross its ends, it is stored with a margin of
// repeated columns and rows:
//
//   0 ... width - 1 | 0 ... kMarginColumns - 1     height rows, then rows 0 to kMarginRows - 1 again
//
// render::kTexelPadding texels follow the last one.
struct TileTexture {
  const void* texels;          // bytes, or colors with alpha 0 where they are full-bright
  std::int32_t width, height;  // without the margin; 0: no texture
};
constexpr std::int32_t kMarginColumns = 16, kMarginRows = 3;

// Spans of one tile of a face.
struct LitSpans {
  render::KernelPlane depth, s, t;  // s and t count from the tile's first texel
  bool perspective;                 // false: parallel projection
  std::int32_t last_s, last_t;      // of the tile
  TileTexture texture;
  std::int32_t first_s, first_t;  // the texel of the texture at the tile's first texel
  const std::uint8_t* colormap;   // for bytes: 64 rows of 256
  const render::Span* spans;
  std::size_t span_count;
};

// The light map of a tile. Cell (column, row) holds the sample there in its low 16 bits, and the one to the
// right of it in its high 16 bits:
//
//   cells[row * columns + column] = sample(column, row) | sample(column + 1, row) << 16
//
// Two rows follow the last one, and kCellPadding cells after that are read and ignored.
struct GridLight {
  const std::uint32_t* cells[kMaxChannels];  // blue, green, red; or one
  std::int32_t channels;                     // 1 or 3
  std::int32_t columns;
  std::int32_t texel_shift;  // samples are 1 << texel_shift texels apart, at most 7
  bool is_nearest;           // false: interpolates between four samples, like surfaces
};
constexpr std::size_t kCellPadding = 16;

// Light that is linear along a part of a span: pixel i of the span has base + step * i, times z if
// `is_over_z`, then clamped to `least` and `most`, which are in the range of light, and rounded.
struct LineLight {
  float base[kMaxChannels], step[kMaxChannels];
  float least[kMaxChannels], most[kMaxChannels];
  // The pixels of the span before this part. Texels and depth are computed from the span's first pixel, so
  // that their last bits do not depend on the parts.
  std::int32_t pixels_before;
};
struct LineLights {
  const LineLight* lines;  // one for each of LitSpans::spans, which are the parts
  std::int32_t channels;   // 1 or 3: blue, green, red
  bool is_over_z;
};

// The light of each pixel of a part of one span, followed by kCellPadding more.
struct PixelLights {
  const std::uint32_t* light;
  std::int32_t pixels_before;  // as in LineLight
};

// For bytes, only the first channel counts.
void draw_grid_lit_u8_scalar(const LitSpans& spans, const GridLight& light,
                             const render::KernelTarget& target);
void draw_grid_lit_u32_scalar(const LitSpans& spans, const GridLight& light,
                              const render::KernelTarget& target);
void draw_line_lit_u8_scalar(const LitSpans& spans, const LineLights& light,
                             const render::KernelTarget& target);
void draw_line_lit_u32_scalar(const LitSpans& spans, const LineLights& light,
                              const render::KernelTarget& target);

// For one span.
void draw_pixel_lit_u8_scalar(const LitSpans& spans, const PixelLights& light,
                              const render::KernelTarget& target);
void draw_pixel_lit_u32_scalar(const LitSpans& spans, const PixelLights& light,
                               const render::KernelTarget& target);

void draw_grid_lit_u8_simd(const LitSpans& spans, const GridLight& light, const render::KernelTarget& target);
void draw_grid_lit_u32_simd(const LitSpans& spans, const GridLight& light,
                            const render::KernelTarget& target);
void draw_line_lit_u8_simd(const LitSpans& spans, const LineLights& light,
                           const render::KernelTarget& target);
void draw_line_lit_u32_simd(const LitSpans& spans, const LineLights& light,
                            const render::KernelTarget& target);
void draw_pixel_lit_u8_simd(const LitSpans& spans, const PixelLights& light,
                            const render::KernelTarget& target);
void draw_pixel_lit_u32_simd(const LitSpans& spans, const PixelLights& light,
                             const render::KernelTarget& target);

}  // namespace temblor::lab
