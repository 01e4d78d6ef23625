// Hot loop. The SIMD versions of z_line_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/perspective/z_line_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/perspective/z_line_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/kernel_inline.h"
#include "render/spans/surface_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void FillZLines(const ZLines& lines, float* out_z) {
  fill_z_lines_scalar(lines, out_z);
}
void DrawLineSpansU8(const LineSpans& spans, const render::KernelTarget& target) {
  draw_line_spans_u8_scalar(spans, target);
}
void DrawLineSpansU32(const LineSpans& spans, const render::KernelTarget& target) {
  draw_line_spans_u32_scalar(spans, target);
}

#else

namespace hn = hwy::HWY_NAMESPACE;
namespace rn = render::HWY_NAMESPACE;

using rn::DF;
using rn::DI;
using rn::VF;
using rn::VI;

void FillZLines(const ZLines& lines, float* out_z) {
  const DF d;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DF()));
  const VF step = hn::Set(d, static_cast<float>(lines.change)), least = hn::Set(d, render::kMinSpanDepth);
  for (int group = 0; group < lines.count; group += kLineGroup) {
    const VF base = hn::Set(d, static_cast<float>(lines.at_origin + lines.change * (lines.first + group)));
    for (int i = 0; i < kLineGroup; i += kLanes) {
      const VF depth = hn::Add(base, hn::Mul(hn::Iota(d, static_cast<float>(i)), step));
      hn::StoreU(hn::Div(hn::Set(d, 1.0f), hn::Max(depth, least)), d, out_z + group + i);
    }
  }
}

HWY_INLINE VF Between(VF near, VF far, VF share) {
  return hn::Add(near, hn::Mul(share, hn::Sub(far, near)));
}

// The distances of a span that crosses a line at each pixel: neighbors in the table.
struct AcrossLines {
  const float* z;
  VF fraction;
  HWY_INLINE VF At(int first, VF /*lane*/) const {
    return Between(hn::LoadU(DF(), z + first), hn::LoadU(DF(), z + first + 1), fraction);
  }
};

HWY_INLINE int Floor(float value) {
  const int whole = static_cast<int>(value);
  return whole - (value < static_cast<float>(whole) ? 1 : 0);
}

// Those of a span that crosses fewer. A vector of pixels needs no more lines than a vector has lanes.
struct SteepLines {
  const float* z;
  float fraction, per_pixel;
  HWY_INLINE VF At(int first, VF lane) const {
    const DF d;
    const VF line = hn::Add(hn::Set(d, fraction), hn::Mul(lane, hn::Set(d, per_pixel)));
    const VF whole = hn::Floor(line);
    const int lowest = per_pixel < 0 ? first + static_cast<int>(hn::Lanes(d)) - 1 : first;
    const int start = Floor(fraction + static_cast<float>(lowest) * per_pixel);
    const VI number = hn::Sub(hn::BitCast(DI(), hn::Add(whole, hn::Set(d, rn::kShift))),
                              hn::Set(DI(), start + rn::kShiftBits));
    const auto pick = hn::IndicesFromVec(d, number);
    return Between(hn::TableLookupLanes(hn::LoadU(d, z + start), pick),
                   hn::TableLookupLanes(hn::LoadU(d, z + start + 1), pick), hn::Sub(line, whole));
  }
};

// Those of a span along a line.
struct OneLine {
  VF z;
  HWY_INLINE VF At(int /*first*/, VF /*lane*/) const { return z; }
};

template <typename Texel, class Distances>
struct LineSpanDrawer {
  const rn::SpanLines& lines;
  const rn::Sampler& sampler;
  const Distances& distances;
  rn::Direction way;
  const Texel* texels;
  rn::SpanOutput<Texel> out;

  template <int kRows>
  TEMBLOR_KERNEL_INLINE void DrawVector(const rn::VectorLines& vectors, VF lane, int i, int count) const {
    const DF d;
    if (out.depth != nullptr) {
      const VF depth = vectors.depth.At(lane);
      if (count == static_cast<int>(hn::Lanes(d)))
        hn::StoreU(depth, d, out.depth + i);
      else
        rn::StoreFirst(d, depth, out.depth + i, count);
    }
    const VF z = distances.At(i, lane);
    const rn::TexelLanes at =
        sampler.template At<false>(hn::Mul(vectors.s.At(lane), z), hn::Mul(vectors.t.At(lane), z));
    rn::Fetch<kRows>(texels, sampler.rows, way, at, out.pixels + i, count);
  }

  template <int kRows>
  TEMBLOR_KERNEL_INLINE void Draw(int count) const {
    const DF d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    const rn::VectorLines vectors(lines);
    VF lane = hn::Iota(d, 0.0f);
    int i = 0;
    for (; i + lanes <= count; i += lanes) {
      DrawVector<kRows>(vectors, lane, i, lanes);
      lane = hn::Add(lane, hn::Set(d, static_cast<float>(lanes)));
    }
    if (i == count) return;
#if HWY_TARGET > HWY_AVX3  // storing a part of a vector is slower than drawing some pixels twice
    if (count > lanes) {
      lane = hn::Iota(d, static_cast<float>(count - lanes));
      return DrawVector<kRows>(vectors, lane, count - lanes, lanes);
    }
#endif
    DrawVector<kRows>(vectors, lane, i, count - i);
  }
};

// The choice of a loop is that of DrawEveryPixel in render/spans/span_kernels_simd.cpp, which also has loops
// for spans that stay inside of their texels. Here they would save little, and take ten seconds to compile.
template <typename Texel, class Distances>
TEMBLOR_KERNEL_INLINE void DrawSpan(const LineSpans& spans, const rn::SpanLines& lines,
                                    const rn::Sampler& sampler, const Distances& distances, int count,
                                    const rn::SpanOutput<Texel>& out) {
  const rn::Walk walk(lines);
  const int rows = walk.RowsNeeded(lines, count);
  const LineSpanDrawer<Texel, Distances> drawer{
      lines, sampler, distances, walk.Way(), static_cast<const Texel*>(spans.surface.texels), out};
  if (rows == 2)
    drawer.template Draw<2>(count);
  else if (rows == 4)
    drawer.template Draw<4>(count);
  else
    drawer.template Draw<0>(count);
}

HWY_INLINE float LevelZ(const float* z, float line) {
  const int whole = Floor(line);
  return z[whole] + (line - static_cast<float>(whole)) * (z[whole + 1] - z[whole]);
}

template <typename Texel>
HWY_INLINE void DrawLineSpans(const LineSpans& spans, const render::KernelTarget& target) {
  const DF d;
  const render::SurfaceSpans& surface = spans.surface;
  const rn::Sampler sampler{hn::Set(d, static_cast<float>(surface.last_s)),
                            hn::Set(d, static_cast<float>(surface.last_t)),
                            {surface.texels_per_row, surface.last_t}};
  rn::SpanLines lines;
  lines.depth.step = static_cast<float>(surface.depth.dx);
  lines.s.step = static_cast<float>(surface.s.dx);
  lines.t.step = static_cast<float>(surface.t.dx);
  const float per_pixel = spans.lines_per_pixel, absolute = per_pixel < 0 ? -per_pixel : per_pixel;
  for (size_t i = 0; i < spans.span_count; ++i) {
    const render::Span& span = spans.spans[i].span;
    const size_t first = span.y * target.width + span.x;
    const rn::SpanOutput<Texel> out{static_cast<Texel*>(target.pixels) + first,
                                    target.depth == nullptr ? nullptr : target.depth + first};
    lines.depth.base = rn::At(surface.depth, span);
    lines.s.base = rn::At(surface.s, span);
    lines.t.base = rn::At(surface.t, span);
    const float* z = spans.z + (spans.spans[i].line - spans.first_line);
    const float fraction = spans.spans[i].fraction, count = static_cast<float>(span.count);
    if (absolute * count <= kLevelShare) {
      const OneLine level{hn::Set(d, LevelZ(z, fraction + (count - 1.0f) * 0.5f * per_pixel))};
      DrawSpan(spans, lines, sampler, level, span.count, out);
    } else if (per_pixel == 1.0f) {
      DrawSpan(spans, lines, sampler, AcrossLines{z, hn::Set(d, fraction)}, span.count, out);
    } else {
      DrawSpan(spans, lines, sampler, SteepLines{z, fraction, per_pixel}, span.count, out);
    }
  }
}

void DrawLineSpansU8(const LineSpans& spans, const render::KernelTarget& target) {
  DrawLineSpans<uint8_t>(spans, target);
}
void DrawLineSpansU32(const LineSpans& spans, const render::KernelTarget& target) {
  DrawLineSpans<uint32_t>(spans, target);
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::lab {

HWY_EXPORT(FillZLines);
HWY_EXPORT(DrawLineSpansU8);
HWY_EXPORT(DrawLineSpansU32);

void fill_z_lines_simd(const ZLines& lines, float* out_z) {
  HWY_DYNAMIC_DISPATCH(FillZLines)(lines, out_z);
}
void draw_line_spans_u8_simd(const LineSpans& spans, const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawLineSpansU8)(spans, target);
}
void draw_line_spans_u32_simd(const LineSpans& spans, const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawLineSpansU32)(spans, target);
}

}  // namespace temblor::lab
#endif
