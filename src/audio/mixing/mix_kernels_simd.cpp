// Hot loop. The SIMD version of mix_kernels_scalar.cpp, compiled once per instruction set by Highway.
#include "audio/mixing/mix_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "audio/mixing/mix_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::audio::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

void Mix(const MixJob& job) {
  mix_scalar(job);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

void Mix(const MixJob& job) {
  const hn::CappedTag<float, 16> d;
  const size_t lanes = hn::Lanes(d);
  const auto left_gain = hn::Set(d, job.left_gain), left_step = hn::Set(d, job.left_step);
  const auto right_gain = hn::Set(d, job.right_gain), right_step = hn::Set(d, job.right_step);
  const auto stride = hn::Set(d, static_cast<float>(lanes));
  auto place = hn::Iota(d, 0.0f);
  size_t i = 0;
  for (; i + lanes <= job.count; i += lanes) {
    const auto samples = hn::LoadU(d, job.samples + i);
    // Multiplies, then adds, like the scalar reference: a fused multiply-add would round differently.
    const auto left = hn::Mul(samples, hn::Add(left_gain, hn::Mul(left_step, place)));
    const auto right = hn::Mul(samples, hn::Add(right_gain, hn::Mul(right_step, place)));
    hn::StoreU(hn::Add(hn::LoadU(d, job.left + i), left), d, job.left + i);
    hn::StoreU(hn::Add(hn::LoadU(d, job.right + i), right), d, job.right + i);
    place = hn::Add(place, stride);
  }
  mix_scalar(job, i);
}

#endif

}  // namespace temblor::audio::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::audio {

HWY_EXPORT(Mix);

void mix_simd(const MixJob& job) {
  HWY_DYNAMIC_DISPATCH(Mix)(job);
}

}  // namespace temblor::audio
#endif
