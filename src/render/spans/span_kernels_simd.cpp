// Hot loop. The SIMD versions of the surface spans of span_kernels_scalar.cpp, compiled once for each
// instruction set. Lane i of a span is base + i * step, whatever the vector's width.
#include "render/spans/span_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/spans/span_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/spans/surface_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawSurfaceSpansU8(const SurfaceSpans& spans, const KernelTarget& target) {
  draw_surface_spans_u8_scalar(spans, target);
}
void DrawSurfaceSpansU32(const SurfaceSpans& spans, const KernelTarget& target) {
  draw_surface_spans_u32_scalar(spans, target);
}

#else

// Draws up to a vector of pixels, whose numbers in the span are `lane`.
template <int kRows, bool kInside, typename Texel>
HWY_INLINE void DrawVector(const VectorLines& lines, const Sampler& sampler, Direction direction,
                           const Texel* texels, VF lane, int count, SpanOutput<Texel> out) {
  const DF d;
  const VF depth = lines.depth.At(lane);
  if (out.depth != nullptr) {
    if (count == static_cast<int>(hn::Lanes(d)))
      hn::StoreU(depth, d, out.depth);
    else
      StoreFirst(d, depth, out.depth, count);
  }
  const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth, hn::Set(d, kMinSpanDepth)));
  const TexelLanes at = sampler.At<kInside>(hn::Mul(lines.s.At(lane), z), hn::Mul(lines.t.At(lane), z));
  Fetch<kRows>(texels, sampler.rows, direction, at, out.pixels, count);
}

template <int kRows, bool kInside, typename Texel>
HWY_INLINE void DrawVectors(const SpanLines& lines, const Sampler& sampler, Direction direction,
                            const Texel* texels, int count, SpanOutput<Texel> out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const VectorLines vector_lines(lines);
  VF lane = hn::Iota(d, 0.0f);
  const auto draw = [&](int i, int now) HWY_ATTR {
    DrawVector<kRows, kInside>(vector_lines, sampler, direction, texels, lane, now, out.At(i));
  };
  int i = 0;
  for (; i + lanes <= count; i += lanes) {
    draw(i, lanes);
    lane = hn::Add(lane, hn::Set(d, static_cast<float>(lanes)));
  }
  if (i == count) return;
#if HWY_TARGET > HWY_AVX3  // storing a part of a vector is slower than drawing some pixels twice
  if (count > lanes) {
    lane = hn::Iota(d, static_cast<float>(count - lanes));
    return draw(count - lanes, lanes);
  }
#endif
  draw(i, count - i);
}

template <typename Texel>
HWY_INLINE void DrawEveryPixel(const SpanLines& lines, const Sampler& sampler, const SurfaceSpans& spans,
                               int count, SpanOutput<Texel> out) {
  const Walk walk(lines);
  const Texel* texels = static_cast<const Texel*>(spans.texels);
  const int rows = walk.RowsNeeded(lines, count);
  const bool inside = count >= kLongSpan && rows > 0 && walk.Inside(lines, spans, count);
  if (rows == 2 && inside)
    DrawVectors<2, true>(lines, sampler, walk.Way(), texels, count, out);
  else if (rows == 2)
    DrawVectors<2, false>(lines, sampler, walk.Way(), texels, count, out);
  else if (rows == 4 && inside)
    DrawVectors<4, true>(lines, sampler, walk.Way(), texels, count, out);
  else if (rows == 4)
    DrawVectors<4, false>(lines, sampler, walk.Way(), texels, count, out);
  else
    DrawVectors<0, false>(lines, sampler, walk.Way(), texels, count, out);
}

template <typename Texel>
HWY_INLINE void DrawAffine(const Line& s, const Line& t, const Sampler& sampler, const Texel* texels,
                           int count, Texel* out) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const int now = count - i < lanes ? count - i : lanes;
    Fetch<4>(texels, sampler.rows, {s.step < 0, t.step < 0}, sampler.At<false>(s.Lanes(i), t.Lanes(i)),
             out + i, now);
  }
}

// Exact at both ends of every `affine_pixels`, affine in between.
template <typename Texel>
HWY_INLINE void DrawAffineParts(const SpanLines& lines, const Sampler& sampler, const Texel* texels,
                                int affine_pixels, int count, Texel* out) {
  const auto z_at = [&](float lane) {
    const float depth = lines.depth.base + lane * lines.depth.step;
    return 1.0f / (depth > kMinSpanDepth ? depth : kMinSpanDepth);
  };
  for (int first = 0; first < count; first += affine_pixels) {
    const int now = count - first < affine_pixels ? count - first : affine_pixels;
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
HWY_INLINE void DrawSurfaceSpans(const SurfaceSpans& spans, const KernelTarget& target) {
  const DF d;
  const Sampler sampler{hn::Set(d, static_cast<float>(spans.last_s)),
                        hn::Set(d, static_cast<float>(spans.last_t)),
                        {spans.texels_per_row, spans.last_t}};
  const Texel* texels = static_cast<const Texel*>(spans.texels);
  SpanLines lines;
  lines.depth.step = static_cast<float>(spans.depth.dx);
  lines.s.step = static_cast<float>(spans.s.dx);
  lines.t.step = static_cast<float>(spans.t.dx);
  for (size_t i = 0; i < spans.span_count; ++i) {
    const Span& span = spans.spans[i];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    float* out_depth = target.depth == nullptr ? nullptr : target.depth + first;
    lines.depth.base = At(spans.depth, span);
    lines.s.base = At(spans.s, span);
    lines.t.base = At(spans.t, span);
    if (spans.divide == KernelDivide::kEveryPixel) {
      DrawEveryPixel(lines, sampler, spans, span.count, SpanOutput<Texel>{out, out_depth});
      continue;
    }
    if (out_depth != nullptr) FillDepth(lines.depth, span.count, out_depth);
    if (spans.divide == KernelDivide::kNone)
      DrawAffine(lines.s, lines.t, sampler, texels, span.count, out);
    else
      DrawAffineParts(lines, sampler, texels, spans.affine_pixels, span.count, out);
  }
}

void DrawSurfaceSpansU8(const SurfaceSpans& spans, const KernelTarget& target) {
  DrawSurfaceSpans<uint8_t>(spans, target);
}
void DrawSurfaceSpansU32(const SurfaceSpans& spans, const KernelTarget& target) {
  DrawSurfaceSpans<uint32_t>(spans, target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawSurfaceSpansU8);
HWY_EXPORT(DrawSurfaceSpansU32);

void draw_surface_spans_u8_simd(const SurfaceSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaceSpansU8)(spans, target);
}
void draw_surface_spans_u32_simd(const SurfaceSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSurfaceSpansU32)(spans, target);
}

}  // namespace temblor::render
#endif
