// Inner loops over spans, as vector code and as plain C++ with the same results, bit for bit. Only plain
// types here: the vector file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/edges/span_run.h"

namespace temblor::render {

// f(x, y) = at_origin + dx x + dy y.
struct KernelPlane {
  double at_origin, dx, dy;
};

// Nearness never reaches zero on a face in view; rounding may bring it there.
constexpr float kFarthest = 1e-20f;
constexpr int kAffinePixels = 16;
// Repeating coordinates beyond this are not told apart: far out on faces that seem to stretch for ever.
constexpr float kFarTexel = 4e6f;
constexpr float kTurnsATexel = 1.0f / 128.0f;

enum class KernelDivide : std::uint8_t { kEveryPixel, kEvery16, kNone };

// Where pixels go. Rows are `width` apart. `depth` null: not filled.
struct KernelTarget {
  void* pixels;
  float* depth;
  std::size_t width;
};

// Whatever texels are read may be followed by this many bytes that are read and not used.
constexpr std::size_t kTexelPadding = 64;

// Spans of one surface. Coordinates are s / depth and t / depth (kNone: s and t), cut off at 0 and at the
// largest ones.
struct SurfaceRuns {
  KernelPlane depth, s, t;
  KernelDivide divide;
  const void* texels;  // bytes or 32-bit colors; rows are `texels_a_row` apart
  std::int32_t texels_a_row;
  std::int32_t last_s, last_t;
  const SpanRun* runs;
  std::size_t run_count;
};

// Spans of a texture that repeats without end, as it is or swaying: s moves by amplitude * (1 + sin of t), a
// full turn every 128 texels, and t by s alike. Coordinates are s / depth and t / depth (without `divide`: s
// and t). Sizes are powers of two, at most 2^15.
struct RepeatRuns {
  KernelPlane depth, s, t;
  bool divide;
  float amplitude;  // texels; 0: still
  float phase;      // texels, added to the coordinate that the sine is taken of
  const void* texels;
  std::int32_t width, height;  // rows follow one another
  const SpanRun* runs;
  std::size_t run_count;
};

// Spans of sky. The ray of pixel (x, y) is forward + x * right + y * down (world space); its direction, with
// z stretched threefold, is scaled to texels of two layers that repeat: clouds, and behind texels that are 0,
// the background. Layer sizes are powers of two, at most 2^15.
struct SkyRuns {
  KernelPlane depth;
  double forward[3], right[3], down[3];
  float scale;                               // texels
  float clouds_s, clouds_t, back_s, back_t;  // how far each has scrolled, from 0 to its size
  const void* clouds;                        // texels as drawn: bytes or 32-bit colors
  const void* back;
  std::int32_t width, height;  // of either layer; rows follow one another
  const SpanRun* runs;
  std::size_t run_count;
};

void draw_surface_runs_u8_scalar(const SurfaceRuns& runs, const KernelTarget& target);
void draw_surface_runs_u32_scalar(const SurfaceRuns& runs, const KernelTarget& target);
void draw_repeat_runs_u8_scalar(const RepeatRuns& runs, const KernelTarget& target);
void draw_repeat_runs_u32_scalar(const RepeatRuns& runs, const KernelTarget& target);
void draw_sky_runs_u8_scalar(const SkyRuns& runs, const KernelTarget& target);
void draw_sky_runs_u32_scalar(const SkyRuns& runs, const KernelTarget& target);

void draw_surface_runs_u8_simd(const SurfaceRuns& runs, const KernelTarget& target);
void draw_surface_runs_u32_simd(const SurfaceRuns& runs, const KernelTarget& target);
void draw_repeat_runs_u8_simd(const RepeatRuns& runs, const KernelTarget& target);
void draw_repeat_runs_u32_simd(const RepeatRuns& runs, const KernelTarget& target);
void draw_sky_runs_u8_simd(const SkyRuns& runs, const KernelTarget& target);
void draw_sky_runs_u32_simd(const SkyRuns& runs, const KernelTarget& target);

}  // namespace temblor::render
