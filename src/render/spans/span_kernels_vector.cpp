// Hot loop. The vector twins of span_kernels_plain.cpp, compiled once for each instruction set. Lane i of a
// run is base + i * step, whatever the vector's width; texels are fetched one by one, which on current
// processors costs no more than a gather and works for bytes.
#include "render/spans/span_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/spans/span_kernels_vector.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawSurfaceRunsU8(const SurfaceRuns& runs, const KernelTarget& target) {
  draw_surface_runs_u8_plain(runs, target);
}
void DrawSurfaceRunsU32(const SurfaceRuns& runs, const KernelTarget& target) {
  draw_surface_runs_u32_plain(runs, target);
}
void FindCoordinates(const CoordinateRun& run) {
  find_coordinates_plain(run);
}
void FindSkyCoordinates(const SkyRun& run) {
  find_sky_coordinates_plain(run);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

constexpr float kFarthest = 1e-20f;
constexpr int kAffinePixels = 16;
constexpr int kMostLanes = 16;

HWY_INLINE float At(const KernelPlane& plane, const KernelRun& run) {
  return static_cast<float>(plane.at_origin + plane.dx * run.x + plane.dy * run.y);
}

// The first `count` lanes only.
HWY_INLINE void StoreFirst(DF d, VF v, float* out, int count) {
#if HWY_TARGET <= HWY_AVX3
  hn::BlendedStore(v, hn::FirstN(d, static_cast<size_t>(count)), d, out);
#else
  HWY_ALIGN float lanes[kMostLanes];
  hn::Store(v, d, lanes);
  for (int i = 0; i < count; ++i) out[i] = lanes[i];
#endif
}

// Texel numbers of up to a vector of pixels.
struct Sampler {
  VF last_s, last_t;
  VI texels_a_row;

  HWY_INLINE VI Texels(VF s, VF t) const {
    const DF d;
    const DI di;
    const VF zero = hn::Zero(d);
    const VI column = hn::ConvertTo(di, hn::Min(hn::Max(s, zero), last_s));
    const VI row = hn::ConvertTo(di, hn::Min(hn::Max(t, zero), last_t));
    return hn::Add(hn::Mul(row, texels_a_row), column);
  }
};

template <typename Texel, int kLanes>
HWY_INLINE void FetchAll(const Texel* HWY_RESTRICT texels, const int32_t* HWY_RESTRICT positions,
                         Texel* HWY_RESTRICT out) {
  for (int i = 0; i < kLanes; ++i) out[i] = texels[positions[i]];
}

template <typename Texel>
HWY_INLINE void Fetch(const Texel* HWY_RESTRICT texels, VI positions, Texel* HWY_RESTRICT out, int count) {
  const DI di;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DI()));
  HWY_ALIGN int32_t numbers[kMostLanes];
  hn::Store(positions, di, numbers);
  if (count == kLanes) {
    FetchAll<Texel, kLanes>(texels, numbers, out);
    return;
  }
  for (int i = 0; i < count; ++i) out[i] = texels[numbers[i]];
}

struct Line {
  float base, step;
  HWY_INLINE VF Lanes(int first) const {
    const DF d;
    const VF lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(first)));
    return hn::Add(hn::Set(d, base), hn::Mul(lane, hn::Set(d, step)));
  }
};

struct RunLines {
  Line depth, s, t;
};

template <typename Texel>
HWY_INLINE void DrawEveryPixel(const RunLines& lines, const Sampler& sampler, const Texel* texels, int count,
                               Texel* out, float* out_depth) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const int now = count - i < lanes ? count - i : lanes;
    const VF depth = lines.depth.Lanes(i);
    if (out_depth != nullptr) {
      if (now == lanes)
        hn::StoreU(depth, d, out_depth + i);
      else
        StoreFirst(d, depth, out_depth + i, now);
    }
    const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kFarthest)));
    const VI positions = sampler.Texels(hn::Mul(lines.s.Lanes(i), z), hn::Mul(lines.t.Lanes(i), z));
    Fetch(texels, positions, out + i, now);
  }
}

HWY_INLINE void FillDepth(const Line& line, int count, float* out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  int i = 0;
  for (; i + lanes <= count; i += lanes) hn::StoreU(line.Lanes(i), d, out + i);
  if (i < count) StoreFirst(d, line.Lanes(i), out + i, count - i);
}

template <typename Texel>
HWY_INLINE void DrawAffine(const Line& s, const Line& t, const Sampler& sampler, const Texel* texels,
                           int count, Texel* out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const int now = count - i < lanes ? count - i : lanes;
    Fetch(texels, sampler.Texels(s.Lanes(i), t.Lanes(i)), out + i, now);
  }
}

// Exact at both ends of every sixteen pixels, affine between.
template <typename Texel>
HWY_INLINE void DrawEvery16(const RunLines& lines, const Sampler& sampler, const Texel* texels, int count,
                            Texel* out) {
  const auto z_at = [&](float lane) {
    const float depth = lines.depth.base + lane * lines.depth.step;
    return 1.0f / (depth > kFarthest ? depth : kFarthest);
  };
  for (int first = 0; first < count; first += kAffinePixels) {
    const int now = count - first < kAffinePixels ? count - first : kAffinePixels;
    const float lane = static_cast<float>(first), end = static_cast<float>(first + now - 1);
    const float z_first = z_at(lane), z_end = z_at(end);
    const float pixels = static_cast<float>(now > 1 ? now - 1 : 1);
    Line s, t;
    s.base = (lines.s.base + lane * lines.s.step) * z_first;
    t.base = (lines.t.base + lane * lines.t.step) * z_first;
    s.step = ((lines.s.base + end * lines.s.step) * z_end - s.base) / pixels;
    t.step = ((lines.t.base + end * lines.t.step) * z_end - t.base) / pixels;
    DrawAffine(s, t, sampler, texels, now, out + first);
  }
}

template <typename Texel>
HWY_INLINE void DrawSurfaceRuns(const SurfaceRuns& runs, const KernelTarget& target) {
  const DF d;
  const DI di;
  const Sampler sampler{hn::Set(d, static_cast<float>(runs.last_s)),
                        hn::Set(d, static_cast<float>(runs.last_t)), hn::Set(di, runs.texels_a_row)};
  const Texel* texels = static_cast<const Texel*>(runs.texels);
  RunLines lines;
  lines.depth.step = static_cast<float>(runs.depth.dx);
  lines.s.step = static_cast<float>(runs.s.dx);
  lines.t.step = static_cast<float>(runs.t.dx);
  for (size_t i = 0; i < runs.run_count; ++i) {
    const KernelRun& run = runs.runs[i];
    const size_t first = run.y * target.width + run.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    float* out_depth = target.depth == nullptr ? nullptr : target.depth + first;
    lines.depth.base = At(runs.depth, run);
    lines.s.base = At(runs.s, run);
    lines.t.base = At(runs.t, run);
    if (runs.divide == KernelDivide::kEveryPixel) {
      DrawEveryPixel(lines, sampler, texels, run.count, out, out_depth);
      continue;
    }
    if (out_depth != nullptr) FillDepth(lines.depth, run.count, out_depth);
    if (runs.divide == KernelDivide::kNone)
      DrawAffine(lines.s, lines.t, sampler, texels, run.count, out);
    else
      DrawEvery16(lines, sampler, texels, run.count, out);
  }
}

void DrawSurfaceRunsU8(const SurfaceRuns& runs, const KernelTarget& target) {
  DrawSurfaceRuns<uint8_t>(runs, target);
}
void DrawSurfaceRunsU32(const SurfaceRuns& runs, const KernelTarget& target) {
  DrawSurfaceRuns<uint32_t>(runs, target);
}

void FindCoordinates(const CoordinateRun& run) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Line depth_line{run.depth, run.depth_step}, s{run.s, run.s_step}, t{run.t, run.t_step};
  const VF one = hn::Set(d, 1.0f);
  for (int i = 0; i < run.count; i += lanes) {
    const int now = run.count - i < lanes ? run.count - i : lanes;
    const VF depth = depth_line.Lanes(i);
    if (run.out_depth != nullptr) StoreFirst(d, depth, run.out_depth + i, now);
    const VF z = run.divide ? hn::Div(one, hn::Max(depth, hn::Set(d, kFarthest))) : one;
    StoreFirst(d, hn::Mul(s.Lanes(i), z), run.out_s + i, now);
    StoreFirst(d, hn::Mul(t.Lanes(i), z), run.out_t + i, now);
  }
}

void FindSkyCoordinates(const SkyRun& run) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Line x_line{run.forward[0], run.step[0]}, y_line{run.forward[1], run.step[1]};
  const Line z_line{run.forward[2], run.step[2]};
  for (int i = 0; i < run.count; i += lanes) {
    const int now = run.count - i < lanes ? run.count - i : lanes;
    const VF x = x_line.Lanes(i), y = y_line.Lanes(i);
    const VF z = hn::Mul(z_line.Lanes(i), hn::Set(d, 3.0f));
    const VF square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
    const VF stretch = hn::Div(hn::Set(d, run.scale), hn::Sqrt(square));
    StoreFirst(d, hn::Mul(x, stretch), run.out_s + i, now);
    StoreFirst(d, hn::Mul(y, stretch), run.out_t + i, now);
  }
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawSurfaceRunsU8);
HWY_EXPORT(DrawSurfaceRunsU32);
HWY_EXPORT(FindCoordinates);
HWY_EXPORT(FindSkyCoordinates);

void draw_surface_runs_u8_vector(const SurfaceRuns& runs, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaceRunsU8)(runs, target);
}
void draw_surface_runs_u32_vector(const SurfaceRuns& runs, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaceRunsU32)(runs, target);
}
void find_coordinates_vector(const CoordinateRun& run) {
  HWY_DYNAMIC_DISPATCH(FindCoordinates)(run);
}
void find_sky_coordinates_vector(const SkyRun& run) {
  HWY_DYNAMIC_DISPATCH(FindSkyCoordinates)(run);
}

}  // namespace temblor::render
#endif
