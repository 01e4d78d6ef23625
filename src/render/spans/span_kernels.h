// Inner loops over spans, as SIMD and as the scalar reference with the same results, bit for bit. This header
// has plain types only, because the SIMD file is compiled for several processors.
//
// A coordinate of pixel i of a span is always base + i * step in float, where base is computed in double at
// the span's first pixel. So results do not depend on the vector's width, and no error accumulates.
//
// 1/z, s/z, and t/z are linear on the screen, so a pixel needs one division. Stock Quake divides only every
// 16 pixels (KernelDivide::kAffine; Michael Abrash, "Quake's 3-D Engine: The Big Picture").
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/edges/span.h"

namespace temblor::render {

// f(x, y) = at_origin + dx * x + dy * y.
struct KernelPlane {
  double at_origin, dx, dy;
};

// 1/z is positive on visible faces, but rounding may bring it to 0: divisions use at least this.
constexpr float kMinSpanDepth = 1e-20f;
// Pixels between two divisions with kAffine, unless the laboratory chooses another number.
constexpr int kAffinePixels = 16;
// Repeating coordinates are clamped to this range, so that they fit an integer; only far parts of enormous
// faces exceed it.
constexpr float kFarTexel = 4e6f;

// How often s and t are divided by depth. kNone: parallel projection, where they are linear.
enum class KernelDivide : std::uint8_t { kEveryPixel, kAffine, kNone };

// The destination. Rows are `width` pixels apart. If `depth` is null, no depth is written.
struct KernelTarget {
  void* pixels;
  float* depth;
  std::size_t width;
};

// Kernels may read this many bytes past the last texel, and ignore them.
constexpr std::size_t kTexelPadding = 64;

// Spans of one surface block. Texel coordinates are s / depth and t / depth (kNone: s and t), clamped to 0
// and to last_s and last_t.
struct SurfaceSpans {
  KernelPlane depth, s, t;
  KernelDivide divide;
  const void* texels;  // bytes or 32-bit colors; rows are `texels_per_row` apart
  std::int32_t texels_per_row;
  std::int32_t last_s, last_t;
  const Span* spans;
  std::size_t span_count;
  std::int32_t affine_pixels = kAffinePixels;
};

// Spans of a texture that repeats endlessly, still or warped: s is displaced by amplitude * (1 + sin of t),
// and t by s in the same way. Coordinates are s / depth and t / depth (without
// `divide`: s and t). Sizes are powers of two, at most 2^15.
struct RepeatSpans {
  KernelPlane depth, s, t;
  bool divide;
  float amplitude;        // texels; 0: still
  float turns_per_texel;  // of the sine
  // In texels; added to the argument of the sine.
  float phase;
  const void* texels;
  std::int32_t width, height;  // rows follow one another
  const Span* spans;
  std::size_t span_count;
};

// Spans of sky. The ray of pixel (x, y) is forward + x * right + y * down (world space). Its direction, with
// z stretched threefold, is scaled to texels of two repeating layers: clouds, and the background behind cloud
// texels that are 0. Layer sizes are powers of two, at most 2^15.
struct SkySpans {
  KernelPlane depth;
  double forward[3], right[3], down[3];
  float scale;                               // texels
  float clouds_s, clouds_t, back_s, back_t;  // how far each has scrolled, from 0 to its size
  const void* clouds;                        // texels as drawn: bytes or 32-bit colors
  const void* back;
  std::int32_t width, height;  // of either layer; rows follow one another
  const Span* spans;
  std::size_t span_count;
};

void draw_surface_spans_u8_scalar(const SurfaceSpans& spans, const KernelTarget& target);
void draw_surface_spans_u32_scalar(const SurfaceSpans& spans, const KernelTarget& target);
void draw_repeat_spans_u8_scalar(const RepeatSpans& spans, const KernelTarget& target);
void draw_repeat_spans_u32_scalar(const RepeatSpans& spans, const KernelTarget& target);
void draw_sky_spans_u8_scalar(const SkySpans& spans, const KernelTarget& target);
void draw_sky_spans_u32_scalar(const SkySpans& spans, const KernelTarget& target);

void draw_surface_spans_u8_simd(const SurfaceSpans& spans, const KernelTarget& target);
void draw_surface_spans_u32_simd(const SurfaceSpans& spans, const KernelTarget& target);
void draw_repeat_spans_u8_simd(const RepeatSpans& spans, const KernelTarget& target);
void draw_repeat_spans_u32_simd(const RepeatSpans& spans, const KernelTarget& target);
void draw_sky_spans_u8_simd(const SkySpans& spans, const KernelTarget& target);
void draw_sky_spans_u32_simd(const SkySpans& spans, const KernelTarget& target);

}  // namespace temblor::render
