// The parts that the SIMD kernels of lit spans share, compiled once for each instruction set: include it
// after hwy/foreach_target.h. DrawLit() draws spans with a sampler, which finds the light of a vector of
// pixels:
//
//   kChannels                1 or 3
//   int BeginSpan(number)    prepares for a span; returns the pixels before it (LineLight::pixels_before)
//   void SetWay(way)         the direction in which the span crosses the texture
//   LightLanes Find(places)
#if defined(TEMBLOR_LAB_WORLD_LIGHT_LIT_SPANS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef TEMBLOR_LAB_WORLD_LIGHT_LIT_SPANS_INL_H
#undef TEMBLOR_LAB_WORLD_LIGHT_LIT_SPANS_INL_H
#else
#define TEMBLOR_LAB_WORLD_LIGHT_LIT_SPANS_INL_H
#endif

#include <hwy/highway.h>

#include "lab/world_light/kernels/lit_kernels.h"
#include "render/kernel_inline.h"
#include "render/spans/fetch_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET != HWY_SCALAR

namespace hn = hwy::HWY_NAMESPACE;
namespace rn = render::HWY_NAMESPACE;

using rn::DF;
using rn::DI;
using rn::DU;
using rn::VF;
using rn::VI;
using VU = hn::Vec<DU>;
using D16 = hn::Repartition<int16_t, DU>;

HWY_INLINE hn::Vec<D16> AsPairs(VU v) {
  return hn::BitCast(D16(), v);
}
HWY_INLINE VU AsWhole(hn::Vec<D16> v) {
  return hn::BitCast(DU(), v);
}
HWY_INLINE VU Twice(VU low) {
  return hn::Or(low, hn::ShiftLeft<16>(low));
}

// Up to a vector of pixels: their numbers in the span, distances, and texels of the tile.
struct Places {
  VF lane, z;
  VI s, t;
  int count;
};

// The light of a vector of pixels, in the low 16 bits of each lane.
template <int kChannels>
struct LightLanes {
  VU channel[kChannels];
};

// Looks up one texel at a time, like the kernel that builds surfaces: a gather is no faster.
template <int kChannels>
HWY_INLINE void StoreLit(VU texels, const LightLanes<kChannels>& light, const LitSpans& spans, uint8_t* out,
                         int count) {
  const DU du;
  constexpr int kLanes = static_cast<int>(hn::MaxLanes(DU()));
  HWY_ALIGN uint32_t positions[kLanes];
  hn::Store(hn::Or(hn::AndNot(hn::Set(du, 255u), light.channel[0]), texels), du, positions);
  if (HWY_LIKELY(count == kLanes)) {
    for (int i = 0; i < kLanes; ++i) out[i] = spans.colormap[positions[i]];
    return;
  }
  for (int i = 0; i < count && i < kLanes; ++i) out[i] = spans.colormap[positions[i]];
}

template <int kChannels>
HWY_INLINE void StoreLit(VU texels, const LightLanes<kChannels>& light, const LitSpans& /*spans*/,
                         uint32_t* out, int count) {
  const DU du;
  const auto lit = [&](VU colors, VU by) HWY_ATTR {
    const auto twice = AsPairs(hn::Add(colors, colors));
    return AsWhole(hn::Min(hn::MulFixedPoint15(twice, AsPairs(by)), hn::Set(D16(), 255)));
  };
  VU green, blue_red;
  if constexpr (kChannels == 3) {
    green = light.channel[1];
    blue_red = hn::Or(light.channel[0], hn::ShiftLeft<16>(light.channel[2]));
  } else {
    green = light.channel[0];
    blue_red = Twice(light.channel[0]);
  }
  const VU alpha = hn::Set(du, 0xff000000u);
  const VU shown_blue_red = lit(hn::And(texels, hn::Set(du, 0xff00ffu)), blue_red);
  const VU shown_green = lit(hn::And(hn::ShiftRight<8>(texels), hn::Set(du, 255u)), green);
  const VU shown = hn::Or(shown_blue_red, hn::ShiftLeft<8>(shown_green));
  const auto is_full_bright = hn::Eq(hn::And(texels, alpha), hn::Zero(du));
  rn::StoreTexels(hn::Or(hn::IfThenElse(is_full_bright, texels, shown), alpha), out, count);
}

// A coordinate of a tile -> the same of its texture.
struct Wrap {
  int size, first;

  // (number + first) mod size. The sum is below 2^15, so the quotient in float is exact.
  HWY_INLINE VI At(VI number) const {
    const DI di;
    const VI moved = hn::Add(number, hn::Set(di, first));
    if ((size & (size - 1)) == 0) return hn::And(moved, hn::Set(di, size - 1));
    const VF share = hn::Set(DF(), 1.0f / static_cast<float>(size));
    const VF quotient = hn::Mul(hn::Add(hn::ConvertTo(DF(), moved), hn::Set(DF(), 0.5f)), share);
    const VI whole = hn::Sub(rn::TruncateBiased(quotient), hn::Set(di, rn::kBias));
    return hn::Sub(moved, hn::Mul(whole, hn::Set(di, size)));
  }
  // Moves all numbers by the same distance, so that the window whose first column or row is `back` before the
  // first lane's begins in the texture; plus kBias.
  HWY_INLINE VI ToWindow(VI number, int back) const {
    const int anchor = hn::GetLane(number) - back;
    const int moved = anchor + first + size * kMarginColumns;  // not negative
    const int wrapped = (size & (size - 1)) == 0 ? moved & (size - 1) : moved % size;
    return hn::Add(number, hn::Set(DI(), wrapped - anchor + rn::kBias));
  }
};

// Fetches texels at coordinates of the tile. `near`: they probably fit a window.
template <typename Texel>
HWY_INLINE void FetchTexels(const LitSpans& spans, rn::Direction way, bool near, VI s, VI t, Texel* out,
                            int count) {
  const TileTexture& texture = spans.texture;
  const auto* texels = static_cast<const Texel*>(texture.texels);
  const rn::Rows rows{texture.width + kMarginColumns, texture.height + kMarginRows - 1};
  const Wrap wrap_s{texture.width, spans.first_s}, wrap_t{texture.height, spans.first_t};
  if (near) {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(DU()));
    const rn::TexelLanes at{wrap_s.ToWindow(s, way.left ? kLanes - 1 : 0),
                            wrap_t.ToWindow(t, way.up ? 3 : 0)};
    if (HWY_LIKELY(rn::FetchWindow<4>(texels, rows, way, at, out, count))) return;
  }
  const VI bias = hn::Set(DI(), rn::kBias);
  rn::FetchScattered(texels, rows, rn::TexelLanes{hn::Add(wrap_s.At(s), bias), hn::Add(wrap_t.At(t), bias)},
                     out, count);
}

struct SpanLines {
  rn::Line depth, s, t;
};

// How a span crosses the texture: s / depth changes by s_change * z * z per pixel, and t likewise.
struct Walk {
  float s_change, t_change;
  HWY_INLINE explicit Walk(const SpanLines& lines, bool perspective)
      : s_change(perspective ? lines.s.step * lines.depth.base - lines.s.base * lines.depth.step
                             : lines.s.step),
        t_change(perspective ? lines.t.step * lines.depth.base - lines.t.base * lines.depth.step
                             : lines.t.step) {}
  HWY_INLINE rn::Direction Way() const { return {s_change < 0, t_change < 0}; }
  // Whether a vector of pixels probably needs no more than four rows and a texel per pixel at the span's far
  // end, where texels are densest.
  HWY_INLINE bool IsNear(const SpanLines& lines, bool perspective, int count) const {
    float least = 1.0f;
    if (perspective) {
      const float last = lines.depth.base + static_cast<float>(count - 1) * lines.depth.step;
      least = last < lines.depth.base ? last : lines.depth.base;
      if (!(least > render::kMinSpanDepth)) return false;
    }
    const float square = least * least;
    const float columns = s_change < 0 ? -s_change : s_change;
    const float rows = (t_change < 0 ? -t_change : t_change) * (static_cast<float>(hn::Lanes(DF())) - 1.0f);
    return columns <= square && rows <= 3.0f * square;
  }
};

// Draws one span, a vector of pixels at a time.
template <typename Texel, class Sampler>
struct SpanDrawer {
  const LitSpans& spans;
  const Sampler& sampler;
  const SpanLines& lines;
  rn::Direction way;
  bool near;   // see Walk::IsNear
  int before;  // pixels of the span, see LineLight
  Texel* out;
  float* out_depth;

  static HWY_INLINE VF At(const rn::Line& line, VF lane) {
    return hn::Add(hn::Set(DF(), line.base), hn::Mul(lane, hn::Set(DF(), line.step)));
  }
  static HWY_INLINE VI Clamp(VF texel, int last) {
    const VF bound = hn::Set(DF(), static_cast<float>(last));
    return hn::Sub(rn::TruncateBiased(hn::Min(hn::Max(texel, hn::Zero(DF())), bound)),
                   hn::Set(DI(), rn::kBias));
  }

  TEMBLOR_KERNEL_INLINE void DrawVector(int i, int count) const {
    const DF d;
    Places places;
    places.count = count;
    places.lane = hn::Iota(d, static_cast<float>(before + i));
    const VF depth = At(lines.depth, places.lane);
    if (out_depth != nullptr) {
      if (count == static_cast<int>(hn::Lanes(d)))
        hn::StoreU(depth, d, out_depth + i);
      else
        rn::StoreFirst(d, depth, out_depth + i, count);
    }
    places.z = hn::Set(d, 1.0f);
    if (spans.perspective) places.z = hn::Div(places.z, hn::Max(depth, hn::Set(d, render::kMinSpanDepth)));
    places.s = Clamp(hn::Mul(At(lines.s, places.lane), places.z), spans.last_s);
    places.t = Clamp(hn::Mul(At(lines.t, places.lane), places.z), spans.last_t);
    HWY_ALIGN Texel fetched[rn::kMaxLanes];
    FetchTexels(spans, way, near, places.s, places.t, fetched, count);
    StoreLit(rn::LoadTexels(fetched), sampler.Find(places), spans, out + i, count);
  }

  HWY_INLINE void Draw(int count) const {
    constexpr int kLanes = static_cast<int>(hn::MaxLanes(DF()));
    int i = 0;
    for (; i + kLanes <= count; i += kLanes) DrawVector(i, kLanes);
    if (i == count) return;
#if HWY_TARGET > HWY_AVX3  // storing a part of a vector is slower than drawing some pixels twice
    if (count > kLanes) {
      DrawVector(count - kLanes, kLanes);
      return;
    }
#endif
    DrawVector(i, count - i);
  }
};

template <typename Texel, class Sampler>
HWY_INLINE void DrawLit(const LitSpans& spans, Sampler sampler, const render::KernelTarget& target) {
  SpanLines lines;
  lines.depth.step = static_cast<float>(spans.depth.dx);
  lines.s.step = static_cast<float>(spans.s.dx);
  lines.t.step = static_cast<float>(spans.t.dx);
  for (size_t number = 0; number < spans.span_count; ++number) {
    const render::Span& span = spans.spans[number];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    float* out_depth = target.depth == nullptr ? nullptr : target.depth + first;
    const int before = sampler.BeginSpan(number);
    const render::Span whole{static_cast<uint16_t>(span.x - before), span.y, 0};
    lines.depth.base = rn::At(spans.depth, whole);
    lines.s.base = rn::At(spans.s, whole);
    lines.t.base = rn::At(spans.t, whole);
    const Walk walk(lines, spans.perspective);
    sampler.SetWay(walk.Way());
    const bool near = walk.IsNear(lines, spans.perspective, before + span.count);
    SpanDrawer<Texel, Sampler>{spans, sampler, lines, walk.Way(), near, before, out, out_depth}.Draw(
        span.count);
  }
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
