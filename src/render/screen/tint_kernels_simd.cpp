// Hot loop. The SIMD version of tint_kernels_scalar.cpp, compiled once for each instruction set.
#include "render/screen/tint_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/screen/tint_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::render::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void TintRgb(const TintJob& job) {
  tint_rgb_scalar(job);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

void TintRgb(const TintJob& job) {
  const hn::CappedTag<uint32_t, 16> du;
  const hn::Repartition<uint16_t, decltype(du)> d16;
  const size_t lanes = hn::Lanes(du);
  const auto under = hn::Set(d16, static_cast<uint16_t>(256 - job.opacity_256));
  // Two channels at a time, in the halves of a lane. The tint's contribution is the same for all pixels.
  const auto over = hn::Set(d16, static_cast<uint16_t>(job.opacity_256));
  const auto round = hn::Set(d16, 128);
  const auto added = [&](uint32_t channels) HWY_ATTR {
    return hn::Add(hn::Mul(hn::BitCast(d16, hn::Set(du, channels)), over), round);
  };
  const auto low_tint = added(job.color & 0x00ff00ffu), high_tint = added(job.color >> 8 & 0xffu);
  const auto two = hn::Set(du, 0x00ff00ffu), one = hn::Set(du, 0xffu);
  size_t i = 0;
  for (; i + lanes <= job.count; i += lanes) {
    const auto own = hn::LoadU(du, job.pixels + i);
    const auto low = hn::Add(hn::Mul(hn::BitCast(d16, hn::And(own, two)), under), low_tint);
    const auto high =
        hn::Add(hn::Mul(hn::BitCast(d16, hn::And(hn::ShiftRight<8>(own), one)), under), high_tint);
    const auto low_out = hn::And(hn::ShiftRight<8>(hn::BitCast(du, low)), two);
    const auto high_out = hn::And(hn::BitCast(du, high), hn::Set(du, 0xff00u));
    hn::StoreU(hn::Or(hn::Or(low_out, high_out), hn::Set(du, 0xff000000u)), du, job.pixels + i);
  }
  tint_rgb_scalar(job, i);
}

#endif

}  // namespace temblor::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::render {

HWY_EXPORT(TintRgb);

void tint_rgb_simd(const TintJob& job) {
  HWY_DYNAMIC_DISPATCH(TintRgb)(job);
}

}  // namespace temblor::render
#endif
