#include "lab/perspective/affine_error.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab {

namespace {

// The position on the texture that a pixel shows, clamped to the block like in the span kernels.
struct TexelPosition {
  double s, t;
};

TexelPosition find_exact(const render::SurfaceDraw& draw, double x, double y) {
  const double z = 1 / std::max(draw.depth.at(x, y), double{render::kMinSpanDepth});
  return {std::clamp(draw.s.at(x, y) * z, 0.0, draw.block.shape.width - 1.0),
          std::clamp(draw.t.at(x, y) * z, 0.0, draw.block.shape.height - 1.0)};
}

// Pixels x to end - 1 of a row: exact at both ends, linear in between.
void compare_part(const render::SurfaceDraw& draw, int y, int x, int end, Counts& io_counts) {
  const TexelPosition first = find_exact(draw, x, y), last = find_exact(draw, end - 1, y);
  for (int i = x + 1; i < end - 1; ++i) {
    const double along = static_cast<double>(i - x) / (end - 1 - x);
    const TexelPosition exact = find_exact(draw, i, y);
    const double s = first.s + (last.s - first.s) * along, t = first.t + (last.t - first.t) * along;
    io_counts.pixels_off += std::floor(s) != std::floor(exact.s) || std::floor(t) != std::floor(exact.t);
    io_counts.max_texel_error =
        std::max({io_counts.max_texel_error, std::abs(s - exact.s), std::abs(t - exact.t)});
  }
}

}  // namespace

Counts find_affine_error(const render::SurfaceDraw& draw, std::span<const render::Span> spans, int pixels) {
  Counts counts;
  for (const render::Span& span : spans)
    for (int i = 0; i < span.count; i += pixels)
      compare_part(draw, span.y, span.x + i, span.x + std::min(i + pixels, int{span.count}), counts);
  return counts;
}

}  // namespace temblor::lab
