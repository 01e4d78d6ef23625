// Hot loop. The SIMD version of depth_kernels_scalar.cpp, compiled once for each instruction set.
#include "lab/hidden_surfaces/depth_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lab/hidden_surfaces/depth_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace temblor::lab::HWY_NAMESPACE {

#if HWY_TARGET == HWY_SCALAR

int32_t TestDepth(const DepthSpan& span, PixelRun* out_runs) {
  return test_depth_scalar(span, out_runs);
}

#else

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using VF = hn::Vec<DF>;

// Whole vectors are usually nearer or farther as a whole; only mixed ones look at single pixels.
int32_t TestDepth(const DepthSpan& span, PixelRun* out_runs) {
  const DF d;
  const auto lanes = static_cast<int32_t>(hn::Lanes(d));
  const VF first = hn::Set(d, span.first), step = hn::Set(d, span.step);
  int32_t runs = 0;
  bool is_inside = false;
  const auto enter = [&](int32_t i) {
    if (!is_inside) out_runs[runs].begin = i;
    is_inside = true;
  };
  const auto leave = [&](int32_t i) {
    if (is_inside) out_runs[runs++].end = i;
    is_inside = false;
  };
  VF number = hn::Iota(d, 0.0f);
  for (int32_t i = 0; i < span.count;
       i += lanes, number = hn::Add(number, hn::Set(d, static_cast<float>(lanes)))) {
    const VF depth = hn::Add(first, hn::Mul(step, number));
    const auto valid = hn::FirstN(d, static_cast<size_t>(span.count - i));
    const auto nearer = hn::And(valid, hn::Gt(depth, hn::LoadU(d, span.depth + i)));
    if (hn::AllFalse(d, nearer)) {
      leave(i);
      continue;
    }
    hn::BlendedStore(depth, nearer, d, span.depth + i);
    if (hn::AllTrue(d, nearer)) {
      enter(i);
      continue;
    }
    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, nearer, bits);
    const uint32_t mask = bits[0] | uint32_t{bits[1]} << 8;
    for (int32_t lane = 0; lane < lanes; ++lane) {
      if ((mask >> lane & 1) != 0)
        enter(i + lane);
      else
        leave(i + lane);
    }
  }
  if (is_inside) out_runs[runs++].end = span.count;
  return runs;
}

#endif

}  // namespace temblor::lab::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace temblor::lab {

HWY_EXPORT(TestDepth);

std::int32_t test_depth_simd(const DepthSpan& span, PixelRun* out_runs) {
  return HWY_DYNAMIC_DISPATCH(TestDepth)(span, out_runs);
}

}  // namespace temblor::lab
#endif
