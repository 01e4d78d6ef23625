// How a span crosses a surface block, and where its texels are: shared by the SIMD kernels that draw surface
// spans, compiled once for each instruction set. Include it after hwy/foreach_target.h.
#if defined(TEMBLOR_RENDER_SPANS_SURFACE_WALK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TEMBLOR_RENDER_SPANS_SURFACE_WALK_INL_H
#undef TEMBLOR_RENDER_SPANS_SURFACE_WALK_INL_H
#else
#define TEMBLOR_RENDER_SPANS_SURFACE_WALK_INL_H
#endif

#include "render/spans/fetch_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

// Pixels. For shorter spans, testing whether a span stays inside its texture costs more than the clamps it
// saves.
constexpr int kLongSpan = 96;
// Texels by which a long span must be inside, to compensate for rounding.
constexpr float kInsideMargin = 1.0f / 64;

// Converts coordinates to texels, clamped to the block. kInside: known to be inside, so nothing is clamped.
struct Sampler {
  VF last_s, last_t;
  Rows rows;

  template <bool kInside>
  HWY_INLINE TexelLanes At(VF s, VF t) const {
    if constexpr (kInside) return {TruncateBiased(s), TruncateBiased(t)};
    const VF zero = hn::Zero(DF());
    return {TruncateBiased(hn::Min(hn::Max(s, zero), last_s)),
            TruncateBiased(hn::Min(hn::Max(t, zero), last_t))};
  }
};

struct SpanLines {
  Line depth, s, t;
};

// The same in vectors, which a loop over a span makes once.
struct VectorLine {
  VF base, step;
  HWY_INLINE explicit VectorLine(const Line& line)
      : base(hn::Set(DF(), line.base)), step(hn::Set(DF(), line.step)) {}
  HWY_INLINE VF At(VF lane) const { return hn::Add(base, hn::Mul(lane, step)); }
};

struct VectorLines {
  VectorLine depth, s, t;
  HWY_INLINE explicit VectorLines(const SpanLines& lines) : depth(lines.depth), s(lines.s), t(lines.t) {}
};

// How a span crosses the texture: s / depth changes by s_change * z * z per pixel, and t likewise (the
// quotient rule).
struct Walk {
  float s_change, t_change;

  HWY_INLINE explicit Walk(const SpanLines& lines)
      : s_change(lines.s.step * lines.depth.base - lines.s.base * lines.depth.step),
        t_change(lines.t.step * lines.depth.base - lines.t.base * lines.depth.step) {}
  HWY_INLINE Direction Way() const { return {s_change < 0, t_change < 0}; }
  // Whether both ends are inside the texture. Then all pixels between are, too, since coordinates are
  // monotonic; kInsideMargin compensates for rounding.
  HWY_INLINE bool Inside(const SpanLines& lines, const SurfaceSpans& spans, int count) const {
    const float end = static_cast<float>(count - 1);
    const float last_depth = lines.depth.base + end * lines.depth.step;
    // The kInsideMargin suffices for numbers of similar size; a large change of depth along a span would
    // increase the rounding errors.
    constexpr float kMaxRatio = 16;
    if (last_depth > lines.depth.base * kMaxRatio || lines.depth.base > last_depth * kMaxRatio) return false;
    const float first_z = 1.0f / lines.depth.base, last_z = 1.0f / last_depth;
    const float first_s = lines.s.base * first_z, last_s = (lines.s.base + end * lines.s.step) * last_z;
    const float first_t = lines.t.base * first_z, last_t = (lines.t.base + end * lines.t.step) * last_z;
    const float max_s = static_cast<float>(spans.last_s) + 1 - kInsideMargin;
    const float max_t = static_cast<float>(spans.last_t) + 1 - kInsideMargin;
    return first_s > kInsideMargin && last_s > kInsideMargin && first_t > kInsideMargin &&
           last_t > kInsideMargin && first_s < max_s && last_s < max_s && first_t < max_t && last_t < max_t;
  }
  // The number of rows of texels under a vector of pixels at the far end of the span, where texels are
  // densest (z squared is 1 / square): 2 or 4. 0: more than four, or more than one texel per pixel.
  HWY_INLINE int RowsNeeded(const SpanLines& lines, int count) const {
    const float last = lines.depth.base + static_cast<float>(count - 1) * lines.depth.step;
    const float least = last < lines.depth.base ? last : lines.depth.base;
    if (!(least > kMinSpanDepth)) return 0;
    const float square = least * least;
    const float columns = s_change < 0 ? -s_change : s_change;
    const float rows = (t_change < 0 ? -t_change : t_change) * (static_cast<float>(hn::Lanes(DF())) - 1.0f);
    return columns > square || rows > 3.0f * square ? 0 : rows > square ? 4 : 2;
  }
};

// The destination of a span's pixels and depth; `depth` may be null.
template <typename Texel>
struct SpanOutput {
  Texel* pixels;
  float* depth;

  HWY_INLINE SpanOutput At(int i) const { return {pixels + i, depth == nullptr ? nullptr : depth + i}; }
};

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
