#include "lab/hidden_surfaces/depth_kernels.h"

namespace temblor::lab {

std::int32_t test_depth_scalar(const DepthSpan& span, PixelRun* out_runs) {
  std::int32_t runs = 0;
  bool is_inside = false;
  for (std::int32_t i = 0; i < span.count; ++i) {
    const float product = span.step * static_cast<float>(i);
    const float depth = span.first + product;
    const bool is_nearer = depth > span.depth[i];
    if (is_nearer) span.depth[i] = depth;
    if (is_nearer && !is_inside) out_runs[runs].begin = i;
    if (!is_nearer && is_inside) out_runs[runs++].end = i;
    is_inside = is_nearer;
  }
  if (is_inside) out_runs[runs++].end = span.count;
  return runs;
}

}  // namespace temblor::lab
