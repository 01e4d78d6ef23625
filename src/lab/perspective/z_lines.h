// Lines of equal z: which ones a surface has, and which of its spans can take their distances from a table of
// them (z_line_kernels.h).
#pragma once

#include "lab/perspective/z_line_kernels.h"
#include "render/surfaces/surface_draws.h"

namespace temblor::lab {

// Numbers the lines of a surface: pixel (x, y) lies at x * per_x + y * per_y. Lines that are nearer to
// vertical than to level are a pixel apart on rows, others on columns.
class SurfaceLines {
 public:
  // Texels of pixels between lines are at most `max_texel_error` off.
  SurfaceLines(const render::SurfaceDraw& draw, double max_texel_error);

  double find_line(double x, double y) const { return x * per_x_ + y * per_y_; }
  double lines_per_pixel() const { return per_x_; }
  // Whether the span is long enough for a table, and no pixel of it is too far off.
  bool has_lines_for(const render::Span& span) const;
  // Without numbers of lines.
  ZLines plane() const { return {depth_.at_origin, change_, 0, 0}; }
  // z of a pixel of a span that has lines, as in the kernels, but in double.
  double find_distance(const render::Span& span, int pixel) const;

 private:
  double interpolate(double line) const;

  render::ScreenPlane depth_;
  double per_x_, per_y_;
  double change_;       // of 1/z, from line to line
  double least_depth_;  // 1/z where the error is the largest that is allowed
};

}  // namespace temblor::lab
