// Hot loop. The SIMD versions of the repeating and sky spans of span_kernels_scalar.cpp, compiled once for
// each instruction set.
#include "render/spans/span_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/spans/repeat_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/spans/fetch_texels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawRepeatSpansU8(const RepeatSpans& spans, const KernelTarget& target) {
  draw_repeat_spans_u8_scalar(spans, target);
}
void DrawRepeatSpansU32(const RepeatSpans& spans, const KernelTarget& target) {
  draw_repeat_spans_u32_scalar(spans, target);
}
void DrawSkySpansU8(const SkySpans& spans, const KernelTarget& target) {
  draw_sky_spans_u8_scalar(spans, target);
}
void DrawSkySpansU32(const SkySpans& spans, const KernelTarget& target) {
  draw_sky_spans_u32_scalar(spans, target);
}

#else

// Warped coordinates leave a narrow window soon: with eight lanes, gathering is faster.
constexpr int kRepeatingRows = hn::MaxLanes(DI()) < 16 ? 0 : 4;

// A texture that repeats: width and height are powers of two.
template <typename Texel>
struct Repeating {
  const Texel* texels;
  int width, height;

  HWY_INLINE void Fetch(VF s, VF t, Texel* out, int count) const {
    const DI di;
    const VI bias = hn::Set(di, kBias);
    const TexelLanes at{hn::Or(hn::And(FloorBiased(s), hn::Set(di, width - 1)), bias),
                        hn::Or(hn::And(FloorBiased(t), hn::Set(di, height - 1)), bias)};
    const size_t last = hn::Lanes(di) - 1;
    const Direction direction{hn::ExtractLane(at.column, last) < hn::GetLane(at.column),
                              hn::ExtractLane(at.row, last) < hn::GetLane(at.row)};
    const Rows rows{width, height - 1};
    temblor::render::HWY_NAMESPACE::Fetch<kRepeatingRows>(texels, rows, direction, at, out, count);
  }
};

template <typename Texel>
HWY_INLINE void DrawSkySpans(const SkySpans& sky, const KernelTarget& target) {
  const DF d;
  const DU du;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Repeating<Texel> clouds{static_cast<const Texel*>(sky.clouds), sky.width, sky.height};
  const Repeating<Texel> back{static_cast<const Texel*>(sky.back), sky.width, sky.height};
  HWY_ALIGN Texel cloud_texels[kMaxLanes], back_texels[kMaxLanes];
  for (size_t r = 0; r < sky.span_count; ++r) {
    const Span& span = sky.spans[r];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    Line ray[3];
    for (int axis = 0; axis < 3; ++axis)
      ray[axis] = {static_cast<float>(sky.forward[axis] + sky.right[axis] * span.x + sky.down[axis] * span.y),
                   static_cast<float>(sky.right[axis])};
    if (target.depth != nullptr)
      FillDepth({At(sky.depth, span), static_cast<float>(sky.depth.dx)}, span.count, target.depth + first);
    for (int i = 0; i < span.count; i += lanes) {
      const VF x = ray[0].Lanes(i), y = ray[1].Lanes(i), z = hn::Mul(ray[2].Lanes(i), hn::Set(d, 3.0f));
      const VF square = hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
      const VF stretch = hn::Div(hn::Set(d, sky.scale), hn::Sqrt(square));
      const VF s = hn::Mul(x, stretch), t = hn::Mul(y, stretch);
      // Both layers are fetched for every pixel; which one shows is decided afterwards.
      clouds.Fetch(hn::Add(s, hn::Set(d, sky.clouds_s)), hn::Add(t, hn::Set(d, sky.clouds_t)), cloud_texels,
                   lanes);
      back.Fetch(hn::Add(s, hn::Set(d, sky.back_s)), hn::Add(t, hn::Set(d, sky.back_t)), back_texels, lanes);
      const auto cloud = LoadTexels(cloud_texels);
      const auto shown = hn::IfThenElse(hn::Eq(cloud, hn::Zero(du)), LoadTexels(back_texels), cloud);
      StoreTexels(shown, out + i, span.count - i < lanes ? span.count - i : lanes);
    }
  }
}

// See `swing` in span_kernels_scalar.cpp.
HWY_INLINE VF Swing(VF turns) {
  const DF d;
  const VF r = hn::Sub(turns, hn::Round(turns));
  const VF parabola =
      hn::Sub(hn::Mul(r, hn::Set(d, 8.0f)), hn::Mul(hn::Mul(r, hn::Abs(r)), hn::Set(d, 16.0f)));
  const VF bend = hn::Mul(hn::Sub(hn::Mul(parabola, hn::Abs(parabola)), parabola), hn::Set(d, 0.225f));
  return hn::Add(hn::Set(d, 1.0f), hn::Add(parabola, bend));
}

HWY_INLINE VF Bounded(VF texel) {
  const DF d;
  return hn::Min(hn::Max(texel, hn::Set(d, -kFarTexel)), hn::Set(d, kFarTexel));
}

template <typename Texel>
HWY_INLINE void DrawRepeatSpans(const RepeatSpans& repeat, const KernelTarget& target) {
  const DF d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const Repeating<Texel> texture{static_cast<const Texel*>(repeat.texels), repeat.width, repeat.height};
  const VF phase = hn::Set(d, repeat.phase), amplitude = hn::Set(d, repeat.amplitude);
  const VF turns_per_texel = hn::Set(d, repeat.turns_per_texel);
  for (size_t r = 0; r < repeat.span_count; ++r) {
    const Span& span = repeat.spans[r];
    const size_t first = span.y * target.width + span.x;
    Texel* out = static_cast<Texel*>(target.pixels) + first;
    const Line depth_line{At(repeat.depth, span), static_cast<float>(repeat.depth.dx)};
    const Line s_line{At(repeat.s, span), static_cast<float>(repeat.s.dx)};
    const Line t_line{At(repeat.t, span), static_cast<float>(repeat.t.dx)};
    if (target.depth != nullptr) FillDepth(depth_line, span.count, target.depth + first);
    for (int i = 0; i < span.count; i += lanes) {
      VF s = s_line.Lanes(i), t = t_line.Lanes(i);
      if (repeat.divide) {
        const VF z = hn::Div(hn::Set(d, 1.0f), hn::Max(depth_line.Lanes(i), hn::Set(d, kMinSpanDepth)));
        s = hn::Mul(s, z);
        t = hn::Mul(t, z);
      }
      s = Bounded(s);
      t = Bounded(t);
      if (repeat.amplitude != 0.0f) {
        const VF s_swing = Swing(hn::Mul(hn::Add(t, phase), turns_per_texel));
        t = hn::Add(t, hn::Mul(Swing(hn::Mul(hn::Add(s, phase), turns_per_texel)), amplitude));
        s = hn::Add(s, hn::Mul(s_swing, amplitude));
      }
      texture.Fetch(s, t, out + i, span.count - i < lanes ? span.count - i : lanes);
    }
  }
}

void DrawRepeatSpansU8(const RepeatSpans& spans, const KernelTarget& target) {
  DrawRepeatSpans<uint8_t>(spans, target);
}
void DrawRepeatSpansU32(const RepeatSpans& spans, const KernelTarget& target) {
  DrawRepeatSpans<uint32_t>(spans, target);
}
void DrawSkySpansU8(const SkySpans& spans, const KernelTarget& target) {
  DrawSkySpans<uint8_t>(spans, target);
}
void DrawSkySpansU32(const SkySpans& spans, const KernelTarget& target) {
  DrawSkySpans<uint32_t>(spans, target);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(DrawRepeatSpansU8);
HWY_EXPORT(DrawRepeatSpansU32);
HWY_EXPORT(DrawSkySpansU8);
HWY_EXPORT(DrawSkySpansU32);

void draw_repeat_spans_u8_simd(const RepeatSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawRepeatSpansU8)(spans, target);
}
void draw_repeat_spans_u32_simd(const RepeatSpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawRepeatSpansU32)(spans, target);
}
void draw_sky_spans_u8_simd(const SkySpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSkySpansU8)(spans, target);
}
void draw_sky_spans_u32_simd(const SkySpans& spans, const KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawSkySpansU32)(spans, target);
}

}  // namespace temblor::render
#endif
