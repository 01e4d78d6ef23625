// Hot loop. The SIMD versions of skybox_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/spans/skybox_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/spans/skybox_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawSkyboxSpansU8(const SkyboxSpans& spans, const KernelTarget& target) {
  draw_skybox_spans_u8_scalar(spans, target);
}
void DrawSkyboxSpansU32(const SkyboxSpans& spans, const KernelTarget& target) {
  draw_skybox_spans_u32_scalar(spans, target);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::Rebind<int32_t, DF>;
using DU = hn::RebindToUnsigned<DI>;
using D8 = hn::Rebind<uint8_t, DU>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;

struct Ray {
  float base[3], step[3];
  HWY_INLINE VF Axis(int axis, VF lane) const {
    const DF d;
    return hn::Add(hn::Set(d, base[axis]), hn::Mul(lane, hn::Set(d, step[axis])));
  }
};

// Positions on the sides, in texels.
struct Places {
  VF u, v;
  VI side;
};

// Computes all three cases and selects, since neighboring pixels may be on different sides.
HWY_INLINE Places FindPlaces(VF x, VF y, VF z, int size) {
  const DF d;
  const DI di;
  const VF ax = hn::Abs(x), ay = hn::Abs(y), az = hn::Abs(z), zero = hn::Zero(d);
  const auto on_x = hn::And(hn::Ge(ax, ay), hn::Ge(ax, az));
  const auto on_y = hn::AndNot(on_x, hn::Ge(ay, az));
  const VF largest = hn::IfThenElse(on_x, ax, hn::IfThenElse(on_y, ay, az));
  const auto x_up = hn::Gt(x, zero), y_up = hn::Gt(y, zero), z_up = hn::Gt(z, zero);
  const VF s_on_x = hn::IfThenElse(x_up, hn::Neg(y), y), s_on_y = hn::IfThenElse(y_up, x, hn::Neg(x));
  const VF s = hn::IfThenElse(on_x, s_on_x, hn::IfThenElse(on_y, s_on_y, hn::Neg(y)));
  const VF t = hn::IfThenElse(hn::Or(on_x, on_y), z, hn::IfThenElse(z_up, hn::Neg(x), x));
  const auto pick = [&](hn::Mask<DF> positive, int yes, int no) HWY_ATTR {
    return hn::IfThenElse(hn::RebindMask(di, positive), hn::Set(di, yes), hn::Set(di, no));
  };
  const VI side =
      hn::IfThenElse(hn::RebindMask(di, on_x), pick(x_up, 0, 2),
                     hn::IfThenElse(hn::RebindMask(di, on_y), pick(y_up, 1, 3), pick(z_up, 4, 5)));
  const float half = static_cast<float>(size) * 0.5f;
  const VF center = hn::Set(d, half + 0.5f);
  return {hn::Add(center, hn::Mul(hn::Div(s, largest), hn::Set(d, half))),
          hn::Sub(center, hn::Mul(hn::Div(t, largest), hn::Set(d, half))), side};
}

HWY_INLINE VI Positions(VI side, VI line, VI column, int row) {
  const DI di;
  const VI rows = hn::Add(hn::Mul(side, hn::Set(di, row)), line);
  return hn::Add(hn::Mul(rows, hn::Set(di, row)), column);
}

HWY_INLINE void StoreTexels(const Places& places, const SkyboxSpans& sky, uint8_t* out) {
  const DI di;
  const DU du;
  const VF round = hn::Set(DF(), 0.5f);
  const VI column = hn::ConvertTo(di, hn::Add(places.u, round));
  const VI line = hn::ConvertTo(di, hn::Add(places.v, round));
  const VI at = Positions(places.side, line, column, sky.size + 2);
  const VU texels = hn::GatherOffset(du, static_cast<const uint32_t*>(sky.texels), at);
  hn::StoreU(hn::TruncateTo(D8(), hn::And(texels, hn::Set(du, 255))), D8(), out);
}

template <int kShift>
HWY_INLINE VU Channel(VU texels) {
  return hn::And(hn::ShiftRight<kShift>(texels), hn::Set(DU(), 255));
}

// Four texels, and how far right and below the position is between them, in 256ths.
struct Four {
  VU above_left, above_right, below_left, below_right, right, below;
  template <int kShift>
  HWY_INLINE VU Mean() const {
    const DU du;
    const VU all = hn::Set(du, 256), left = hn::Sub(all, right);
    const VU above_sum =
        hn::Add(hn::Mul(Channel<kShift>(above_left), left), hn::Mul(Channel<kShift>(above_right), right));
    const VU below_sum =
        hn::Add(hn::Mul(Channel<kShift>(below_left), left), hn::Mul(Channel<kShift>(below_right), right));
    const VU sum = hn::Add(hn::Mul(above_sum, hn::Sub(all, below)), hn::Mul(below_sum, below));
    return hn::ShiftLeft<kShift>(hn::ShiftRight<16>(hn::Add(sum, hn::Set(du, 32768))));
  }
};

// The fraction of a coordinate, in 256ths.
HWY_INLINE VU Share(VF place, VI whole) {
  const DF d;
  const VF part = hn::Sub(place, hn::ConvertTo(d, whole));
  return hn::BitCast(DU(), hn::ConvertTo(DI(), hn::Mul(part, hn::Set(d, 256.0f))));
}

HWY_INLINE void StoreTexels(const Places& places, const SkyboxSpans& sky, uint32_t* out) {
  const DI di;
  const DU du;
  const VI column = hn::ConvertTo(di, places.u), line = hn::ConvertTo(di, places.v);
  const int row = sky.size + 2;
  const VI at = Positions(places.side, line, column, row);
  const auto* const texels = static_cast<const uint32_t*>(sky.texels);
  const Four four{hn::GatherIndex(du, texels, at),
                  hn::GatherIndex(du, texels + 1, at),
                  hn::GatherIndex(du, texels + row, at),
                  hn::GatherIndex(du, texels + row + 1, at),
                  Share(places.u, column),
                  Share(places.v, line)};
  const VU color = hn::Or(hn::Or(four.Mean<0>(), four.Mean<8>()), four.Mean<16>());
  hn::StoreU(hn::Or(color, hn::Set(du, 0xff000000u)), du, out);
}

// Draws whole vectors. Returns the number of pixels drawn; the scalar kernel draws the rest.
template <typename Texel>
HWY_INLINE int DrawSpan(const SkyboxSpans& sky, const Span& span, const KernelTarget& target) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const size_t first = span.y * target.width + span.x;
  const float depth = static_cast<float>(sky.depth.at_origin + sky.depth.dx * span.x + sky.depth.dy * span.y);
  const float depth_step = static_cast<float>(sky.depth.dx);
  Ray ray;
  for (int axis = 0; axis < 3; ++axis) {
    ray.base[axis] =
        static_cast<float>(sky.forward[axis] + sky.right[axis] * span.x + sky.down[axis] * span.y);
    ray.step[axis] = static_cast<float>(sky.right[axis]);
  }
  int i = 0;
  for (; i + lanes <= span.count; i += lanes) {
    const VF lane = hn::Add(hn::Iota(d, 0.0f), hn::Set(d, static_cast<float>(i)));
    if (target.depth != nullptr)
      hn::StoreU(hn::Add(hn::Set(d, depth), hn::Mul(lane, hn::Set(d, depth_step))), d,
                 target.depth + first + static_cast<size_t>(i));
    const Places places = FindPlaces(ray.Axis(0, lane), ray.Axis(1, lane), ray.Axis(2, lane), sky.size);
    StoreTexels(places, sky, static_cast<Texel*>(target.pixels) + first + static_cast<size_t>(i));
  }
  return i;
}

void DrawSkyboxSpansU8(const SkyboxSpans& spans, const KernelTarget& target) {
  for (size_t i = 0; i < spans.span_count; ++i)
    draw_skybox_span_u8_scalar(spans, spans.spans[i], DrawSpan<uint8_t>(spans, spans.spans[i], target),
                               target);
}
void DrawSkyboxSpansU32(const SkyboxSpans& spans, const KernelTarget& target) {
  for (size_t i = 0; i < spans.span_count; ++i)
    draw_skybox_span_u32_scalar(spans, spans.spans[i], DrawSpan<uint32_t>(spans, spans.spans[i], target),
                                target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawSkyboxSpansU8);
HWY_EXPORT(DrawSkyboxSpansU32);

void draw_skybox_spans_u8_simd(const SkyboxSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSkyboxSpansU8)(spans, target);
}
void draw_skybox_spans_u32_simd(const SkyboxSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSkyboxSpansU32)(spans, target);
}

}  // namespace temblor::render
#endif
