// Hot loop. The SIMD versions of phong_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/world_light/kernels/phong_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/world_light/kernels/phong_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lab/world_light/kernels/lit_spans-inl.h"

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void DrawPhongLitU8(const LitSpans& spans, const PhongLights& light, const render::KernelTarget& target) {
  draw_phong_lit_u8_scalar(spans, light, target);
}
void DrawPhongLitU32(const LitSpans& spans, const PhongLights& light, const render::KernelTarget& target) {
  draw_phong_lit_u32_scalar(spans, light, target);
}

#else

constexpr float kFullSum = 65280;

struct Vec3Lanes {
  VF x, y, z;
  HWY_INLINE VF Dot(const Vec3Lanes& b) const {
    return hn::Add(hn::Add(hn::Mul(x, b.x), hn::Mul(y, b.y)), hn::Mul(z, b.z));
  }
};

template <bool kDark>
struct LampSampler {
  static constexpr int kChannels = 1;
  const PhongLights& lights;
  const PhongPart* part = nullptr;

  HWY_INLINE int BeginSpan(size_t number) {
    part = &lights.parts[number];
    return part->pixels_before;
  }
  HWY_INLINE void SetWay(rn::Direction /*way*/) {}

  static HWY_INLINE VF Along(float base, float step, VF lane) {
    return hn::Add(hn::Set(DF(), base), hn::Mul(lane, hn::Set(DF(), step)));
  }
  HWY_INLINE VF SumLight(const Places& places) const {
    const DF d;
    const auto at = [&](int i) HWY_ATTR {
      return hn::Mul(Along(part->ray[i], lights.ray_step[i], places.lane), places.z);
    };
    const auto normal_at = [&](int i)
                               HWY_ATTR { return Along(part->normal[i], part->normal_step[i], places.lane); };
    const VF at_x = at(0), at_y = at(1), at_z = at(2);
    const Vec3Lanes normal{normal_at(0), normal_at(1), normal_at(2)};
    const VF per_length = hn::Div(hn::Set(d, 0.5f), hn::Sqrt(normal.Dot(normal)));
    VF sum = hn::Zero(d);
    for (int32_t i = 0; i < lights.lamp_count; ++i) {
      const PointLamp& lamp = lights.lamps[i];
      const Vec3Lanes to_lamp{hn::Sub(hn::Set(d, lamp.from_eye[0]), at_x),
                              hn::Sub(hn::Set(d, lamp.from_eye[1]), at_y),
                              hn::Sub(hn::Set(d, lamp.from_eye[2]), at_z)};
      const VF distance = hn::Max(hn::Sqrt(to_lamp.Dot(to_lamp)), hn::Set(d, 1.0f));
      const VF per_distance = hn::Div(hn::Set(d, 1.0f), distance);
      const VF half_cosine = hn::Mul(hn::Mul(normal.Dot(to_lamp), per_length), per_distance);
      const VF linear = hn::Max(
          hn::Sub(hn::Set(d, lamp.brightness), hn::Mul(hn::Set(d, lamp.falloff), distance)), hn::Zero(d));
      const VF curved =
          hn::Mul(hn::Add(hn::Set(d, lamp.inverse), hn::Mul(hn::Set(d, lamp.inverse_square), per_distance)),
                  per_distance);
      const Vec3Lanes spot{hn::Set(d, lamp.spot[0]), hn::Set(d, lamp.spot[1]), hn::Set(d, lamp.spot[2])};
      const VF from_lamp = hn::Sub(hn::Zero(d), spot.Dot(to_lamp));
      const auto is_in_cone = hn::Ge(from_lamp, hn::Mul(hn::Set(d, lamp.spot_cosine), distance));
      const VF light = hn::Mul(hn::Add(linear, curved), hn::Add(half_cosine, hn::Set(d, 0.5f)));
      sum = hn::Add(sum, hn::IfThenElseZero(is_in_cone, light));
    }
    return sum;
  }
  HWY_INLINE LightLanes<1> Find(const Places& places) const {
    const DF d;
    const VF sum = hn::Min(SumLight(places), hn::Set(d, kFullSum));
    VF light = hn::Mul(sum, hn::Set(d, 0.5f));
    if constexpr (kDark)
      light = hn::Max(hn::Mul(hn::Sub(hn::Set(d, kFullSum), sum), hn::Set(d, 0.25f)), hn::Set(d, 64.0f));
    const VI whole = rn::TruncateBiased(hn::Add(light, hn::Set(d, 0.5f)));
    return {{hn::BitCast(DU(), hn::Sub(whole, hn::Set(DI(), rn::kBias)))}};
  }
};

void DrawPhongLitU8(const LitSpans& spans, const PhongLights& light, const render::KernelTarget& target) {
  DrawLit<uint8_t>(spans, LampSampler<true>{light}, target);
}
void DrawPhongLitU32(const LitSpans& spans, const PhongLights& light, const render::KernelTarget& target) {
  DrawLit<uint32_t>(spans, LampSampler<false>{light}, target);
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::lab {

HWY_EXPORT(DrawPhongLitU8);
HWY_EXPORT(DrawPhongLitU32);

void draw_phong_lit_u8_simd(const LitSpans& spans, const PhongLights& light,
                            const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawPhongLitU8)(spans, light, target);
}
void draw_phong_lit_u32_simd(const LitSpans& spans, const PhongLights& light,
                             const render::KernelTarget& target) {
  HWY_DYNAMIC_DISPATCH(DrawPhongLitU32)(spans, light, target);
}

}  // namespace temblor::lab
#endif
