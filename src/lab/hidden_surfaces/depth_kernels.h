// Inner loop of the depth buffer, as SIMD and as the scalar reference with the same results, bit for bit.
// This header has plain types only, because the SIMD file is compiled for several processors.
#pragma once

#include <cstdint>

namespace temblor::lab {

constexpr int kDepthPadding = 16;

// A span of one surface: pixel i has the depth first + step * i.
struct DepthSpan {
  // The depth buffer at the span's first pixel. Up to kDepthPadding values after the span are read, and
  // written as they are.
  float* depth;
  std::int32_t count;
  float first, step;
};

// Pixels `begin` to `end` - 1 of the span.
struct PixelRun {
  std::int32_t begin, end;
};

// Stores the span's depth where it is greater (nearer) than the buffer's. Writes the runs of such pixels to
// `out_runs`, which has room for (count + 1) / 2, and returns their number.
std::int32_t test_depth_scalar(const DepthSpan& span, PixelRun* out_runs);
std::int32_t test_depth_simd(const DepthSpan& span, PixelRun* out_runs);

}  // namespace temblor::lab
