#include "lab/perspective/z_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::lab {

namespace {

// Shorter spans are divided: a table would be as much work. Longer ones need too large a table.
constexpr int kMinPixels = 16, kMaxPixels = 3000;

// Between two lines, interpolation makes z larger by at most change^2 / (4 * depth * next_depth) of itself,
// and texel coordinates as well, which are at most `texels`.
double find_least_depth(double change, double texels, double max_texel_error) {
  if (max_texel_error == 0) return std::numeric_limits<double>::infinity();
  const double least = std::abs(change) * (1 + std::sqrt(texels / (4 * max_texel_error)));
  return std::max(least, double{render::kMinSpanDepth});
}

}  // namespace

SurfaceLines::SurfaceLines(const render::SurfaceDraw& draw, double max_texel_error) : depth_(draw.depth) {
  const bool is_steep = std::abs(depth_.dx) <= kMaxLinesPerPixel * std::abs(depth_.dy);
  change_ = is_steep ? depth_.dy : depth_.dx;
  per_x_ = change_ == 0 ? 0 : depth_.dx / change_;
  per_y_ = change_ == 0 ? 1 : depth_.dy / change_;
  const render::SurfaceShape& shape = draw.block.shape;
  least_depth_ = find_least_depth(change_, std::max(shape.width, shape.height), max_texel_error);
}

bool SurfaceLines::has_lines_for(const render::Span& span) const {
  if (span.count < kMinPixels || span.count > kMaxPixels) return false;
  const double first = depth_.at(span.x, span.y), last = first + depth_.dx * (span.count - 1);
  return std::min(first, last) >= least_depth_;
}

double SurfaceLines::find_distance(const render::Span& span, int pixel) const {
  const double first = find_line(span.x, span.y);
  const bool is_level = std::abs(per_x_) * span.count <= kLevelShare;
  return interpolate(first + per_x_ * (is_level ? (span.count - 1) * 0.5 : pixel));
}

double SurfaceLines::interpolate(double line) const {
  const auto compute_z = [&](double whole) { return 1 / (depth_.at_origin + change_ * whole); };
  const double whole = std::floor(line);
  return compute_z(whole) + (line - whole) * (compute_z(whole + 1) - compute_z(whole));
}

}  // namespace temblor::lab
