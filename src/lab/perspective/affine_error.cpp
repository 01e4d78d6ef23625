#include "lab/perspective/affine_error.h"

#include <algorithm>

#include "lab/perspective/texel_error.h"

namespace temblor::lab {

namespace {

// Pixels x to end - 1 of a row: exact at both ends, linear in between.
void compare_part(const render::SurfaceDraw& draw, int y, int x, int end, Counts& io_counts) {
  const TexelPosition first = find_exact_texel(draw, {x, y}), last = find_exact_texel(draw, {end - 1, y});
  for (int i = x + 1; i < end - 1; ++i) {
    const double along = static_cast<double>(i - x) / (end - 1 - x);
    compare_texels({first.s + (last.s - first.s) * along, first.t + (last.t - first.t) * along},
                   find_exact_texel(draw, {i, y}), io_counts);
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
