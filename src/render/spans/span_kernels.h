// Inner loops over spans, as vector code and as plain C++ with the same results, bit for bit. Only plain
// types here: the vector file is compiled for several processors.
#pragma once

#include <cstddef>
#include <cstdint>

namespace temblor::render {

// f(x, y) = at_origin + dx x + dy y.
struct KernelPlane {
  double at_origin, dx, dy;
};

struct KernelRun {
  std::uint16_t x, y, count;
};

enum class KernelDivide : std::uint8_t { kEveryPixel, kEvery16, kNone };

// Where pixels go. Rows are `width` apart. `depth` null: not filled.
struct KernelTarget {
  void* pixels;
  float* depth;
  std::size_t width;
};

// Spans of one surface. Coordinates are s / depth and t / depth (kNone: s and t), cut off at 0 and at the
// largest ones.
struct SurfaceRuns {
  KernelPlane depth, s, t;
  KernelDivide divide;
  const void* texels;  // bytes or 32-bit colours; rows are `texels_a_row` apart
  std::int32_t texels_a_row;
  std::int32_t last_s, last_t;
  const KernelRun* runs;
  std::size_t run_count;
};

// Along one run: pixel i has (base + i * step), in float, for each of the three.
struct CoordinateRun {
  float depth, depth_step, s, s_step, t, t_step;
  bool divide;
  std::int32_t count;
  float* out_depth;  // null: not filled
  float* out_s;      // texel coordinates
  float* out_t;
};

// The sky's texel coordinates for the ray forward + i * step, i = 0..count-1 (world space).
struct SkyRun {
  float forward[3], step[3];
  float scale;  // texels of the layer at the horizon
  std::int32_t count;
  float* out_s;
  float* out_t;
};

void draw_surface_runs_u8_plain(const SurfaceRuns& runs, const KernelTarget& target);
void draw_surface_runs_u32_plain(const SurfaceRuns& runs, const KernelTarget& target);
void find_coordinates_plain(const CoordinateRun& run);
void find_sky_coordinates_plain(const SkyRun& run);

void draw_surface_runs_u8_vector(const SurfaceRuns& runs, const KernelTarget& target);
void draw_surface_runs_u32_vector(const SurfaceRuns& runs, const KernelTarget& target);
void find_coordinates_vector(const CoordinateRun& run);
void find_sky_coordinates_vector(const SkyRun& run);

}  // namespace temblor::render
