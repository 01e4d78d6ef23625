// One triangle, scan line by scan line. Not for kernels that are compiled for several processors: it has
// function bodies.
//
// Method: what is covered is found in whole numbers. Corners lie at multiples of 1/256 pixel, so the pixel at
// which a row begins to lie right of an edge is the quotient of two whole numbers below 2^53, rounded up, and
// a double's division finds it exactly. A pixel's center on a left or top edge is inside, on a right or
// bottom one outside: triangles that share an edge cover each pixel along it once. Depth, texels and light
// are linear on the screen, from gradients whose common denominator is the cross product that also tells back
// faces and degenerate triangles.
#pragma once

#include <array>
#include <cstdint>

#include "render/alias/triangle_kernels.h"

namespace temblor::render {

// The first pixel of a row that lies right of an edge, row after row.
class EdgeColumns {
 public:
  // From the upper to the lower end, which is lower by at least one step. `row` is the first one asked for.
  EdgeColumns(const ScreenVertex& upper, const ScreenVertex& lower, std::int32_t row) {
    const std::int64_t dx = std::int64_t{lower.x} - upper.x, dy = std::int64_t{lower.y} - upper.y;
    numerator_ = static_cast<double>(upper.x * dy + (std::int64_t{row} * kSubpixels - upper.y) * dx);
    step_ = static_cast<double>(dx * kSubpixels);
    denominator_ = static_cast<double>(dy * kSubpixels);
  }
  // Cut off at 0 and at `width`.
  std::int32_t next(double width) {
    double quotient = numerator_ / denominator_;
    numerator_ += step_;
    quotient = quotient > 0 ? quotient : 0;
    quotient = quotient < width ? quotient : width;
    const auto whole = static_cast<std::int32_t>(quotient);
    return whole + (quotient > whole ? 1 : 0);
  }

 private:
  double numerator_, step_, denominator_;
};

// Linear over the screen, known at one corner.
struct ScreenGradient {
  double at_corner, dx, dy;  // a pixel
};

// What is interpolated over a triangle: depth, light and texels; in perspective s and t are times depth.
struct TriangleGradients {
  ScreenGradient depth, light, s, t;
  bool perspective;
  double corner_x, corner_y;  // pixels
};

// A run of pixels in one row.
struct TriangleRun {
  std::int32_t x, y, count;
  float depth, light, s, t;  // at its first pixel
  float depth_step, light_step, s_step, t_step;
  bool perspective;
};

inline bool needs_perspective(const ScreenVertex* const corner[3], const TexelPoint* const texel[3]) {
  const auto range = [](float a, float b, float c, float& out_least) {
    const float least = a < b ? (a < c ? a : c) : (b < c ? b : c);
    const float most = a > b ? (a > c ? a : c) : (b > c ? b : c);
    out_least = least;
    return most - least;
  };
  float farthest, unused;
  const float depth_range = range(corner[0]->depth, corner[1]->depth, corner[2]->depth, farthest);
  const float s_range = range(texel[0]->s, texel[1]->s, texel[2]->s, unused);
  const float t_range = range(texel[0]->t, texel[1]->t, texel[2]->t, unused);
  // Halfway between two ends whose nearness has the ratio r, an affine coordinate is off by about (r - 1) / 4
  // of its range.
  return (s_range > t_range ? s_range : t_range) * depth_range > 4 * kAffineErrorTexels * farthest;
}

// `cross` is positive: twice the area, in steps of 1/kSubpixels squared.
inline TriangleGradients triangle_gradients(const ScreenVertex* const corner[3],
                                            const TexelPoint* const texel[3], double cross,
                                            bool perspective) {
  const double to_pixels = kSubpixels / cross;
  const double x1 = (corner[1]->x - corner[0]->x) * to_pixels;
  const double y1 = (corner[1]->y - corner[0]->y) * to_pixels;
  const double x2 = (corner[2]->x - corner[0]->x) * to_pixels;
  const double y2 = (corner[2]->y - corner[0]->y) * to_pixels;
  const auto gradient = [&](double a, double b, double c) {
    return ScreenGradient{a, (b - a) * y2 - (c - a) * y1, (c - a) * x1 - (b - a) * x2};
  };
  const double d0 = corner[0]->depth, d1 = corner[1]->depth, d2 = corner[2]->depth;
  TriangleGradients gradients;
  gradients.perspective = perspective;
  gradients.corner_x = corner[0]->x * (1.0 / kSubpixels);
  gradients.corner_y = corner[0]->y * (1.0 / kSubpixels);
  gradients.depth = gradient(d0, d1, d2);
  gradients.light = gradient(corner[0]->light, corner[1]->light, corner[2]->light);
  const double w0 = perspective ? d0 : 1, w1 = perspective ? d1 : 1, w2 = perspective ? d2 : 1;
  gradients.s = gradient(texel[0]->s * w0, texel[1]->s * w1, texel[2]->s * w2);
  gradients.t = gradient(texel[0]->t * w0, texel[1]->t * w1, texel[2]->t * w2);
  return gradients;
}

inline TriangleRun run_at(const TriangleGradients& gradients, std::int32_t x, std::int32_t y,
                          std::int32_t count) {
  const double from_x = x - gradients.corner_x, from_y = y - gradients.corner_y;
  const auto at = [&](const ScreenGradient& g) {
    return static_cast<float>(g.at_corner + g.dx * from_x + g.dy * from_y);
  };
  return {x,
          y,
          count,
          at(gradients.depth),
          at(gradients.light),
          at(gradients.s),
          at(gradients.t),
          static_cast<float>(gradients.depth.dx),
          static_cast<float>(gradients.light.dx),
          static_cast<float>(gradients.s.dx),
          static_cast<float>(gradients.t.dx),
          gradients.perspective};
}

// Nearness in view is never as little; rounding may bring it there.
constexpr float kMinDepth = 1e-20f;

// The palette index that a pixel of the run shows.
inline std::uint8_t skin_texel(const TriangleJob& job, const TriangleRun& run, float lane, float depth) {
  float s = run.s + lane * run.s_step, t = run.t + lane * run.t_step;
  if (run.perspective) {
    const float z = 1.0f / (depth > kMinDepth ? depth : kMinDepth);
    s *= z;
    t *= z;
  }
  const auto inside = [](float texel, std::int32_t size) {
    const float last = static_cast<float>(size - 1);
    const float most = texel < last ? texel : last;
    return static_cast<std::int32_t>(most > 0 ? most : 0);
  };
  return job.skin[inside(t, job.skin_height) * job.skin_width + inside(s, job.skin_width)];
}

inline std::int32_t run_light(const TriangleRun& run, float lane, float most) {
  const float light = run.light + lane * run.light_step;
  const float bounded = light < most ? light : most;
  return static_cast<std::int32_t>(bounded > 0 ? bounded : 0);
}

// What a texel shows as under light.
inline std::uint8_t lit_texel(const TriangleJob& job, std::uint8_t texel, const TriangleRun& run, float lane,
                              std::uint8_t) {
  const std::int32_t light = run_light(run, lane, kDarkestRow);
  return static_cast<const std::uint8_t*>(job.colors)[(light & ~255) + texel];
}
inline std::uint32_t lit_texel(const TriangleJob& job, std::uint8_t texel, const TriangleRun& run, float lane,
                               std::uint32_t) {
  const std::uint32_t color = static_cast<const std::uint32_t*>(job.colors)[texel];
  if (color >> 24 == 0) return color | 0xff000000u;
  const std::int32_t light = run_light(run, lane, kBrightestLight);
  std::uint32_t lit = 0xff000000u;
  for (int channel = 0; channel < 3; ++channel) {
    const int shift = 16 - 8 * channel;
    const std::int32_t tinted = (light * job.tint[channel]) >> 15;
    const std::int32_t value = (static_cast<std::int32_t>(color >> shift & 255) * 2 * tinted + 16384) >> 15;
    lit |= static_cast<std::uint32_t>(value < 255 ? value : 255) << shift;
  }
  return lit;
}

// Calls draw_run(run) for each row of the triangle that has pixels, from top to bottom; not at all for one
// that shows its back or has no area.
template <typename DrawRun>
void draw_affine_triangle(const TriangleJob& job, std::size_t number, const TriangleTarget& target,
                          DrawRun draw_run) {
  const std::uint32_t* index = job.triangles + number * 3;
  const ScreenVertex* const corner[3] = {job.vertices + index[0], job.vertices + index[1],
                                         job.vertices + index[2]};
  const std::int64_t cross =
      (std::int64_t{corner[1]->x} - corner[0]->x) * (std::int64_t{corner[2]->y} - corner[0]->y) -
      (std::int64_t{corner[2]->x} - corner[0]->x) * (std::int64_t{corner[1]->y} - corner[0]->y);
  if (cross <= 0) return;

  // Corners from the top; a swap turns the way they go round.
  const ScreenVertex *top = corner[0], *middle = corner[1], *bottom = corner[2];
  bool middle_is_right = true;
  const auto order = [&](const ScreenVertex*& io_upper, const ScreenVertex*& io_lower) {
    if (io_upper->y <= io_lower->y) return;
    const ScreenVertex* const swapped = io_upper;
    io_upper = io_lower;
    io_lower = swapped;
    middle_is_right = !middle_is_right;
  };
  order(top, middle);
  order(middle, bottom);
  order(top, middle);

  static_assert(kSubpixels == 1 << 8);
  const auto first_pixel = [](std::int32_t y) { return (y + (kSubpixels - 1)) >> 8; };
  const auto inside = [&](std::int32_t row) {
    return row < target.row_begin ? target.row_begin : row > target.row_end ? target.row_end : row;
  };
  const std::int32_t first = inside(first_pixel(top->y)), last = inside(first_pixel(bottom->y));
  if (first >= last) return;
  const auto least = [](std::int32_t a, std::int32_t b) { return a < b ? a : b; };
  const auto most = [](std::int32_t a, std::int32_t b) { return a < b ? b : a; };
  const std::int32_t left = least(least(corner[0]->x, corner[1]->x), corner[2]->x);
  const std::int32_t right = most(most(corner[0]->x, corner[1]->x), corner[2]->x);
  if (first_pixel(left) >= first_pixel(right)) return;
  const std::int32_t turn = inside(first_pixel(middle->y));

  const TexelPoint* const texel[3] = {job.texels + index[0], job.texels + index[1], job.texels + index[2]};
  const TriangleGradients gradients = triangle_gradients(corner, texel, static_cast<double>(cross),
                                                         job.perspective && needs_perspective(corner, texel));
  const double width = target.width;
  EdgeColumns whole(*top, *bottom, first);
  const auto draw_rows = [&](std::int32_t begin, std::int32_t end, EdgeColumns part) {
    for (std::int32_t y = begin; y < end; ++y) {
      const std::int32_t a = whole.next(width), b = part.next(width);
      const std::int32_t begin_x = middle_is_right ? a : b, end_x = middle_is_right ? b : a;
      if (begin_x < end_x) draw_run(run_at(gradients, begin_x, y, end_x - begin_x));
    }
  };
  if (first < turn) draw_rows(first, turn, EdgeColumns(*top, *middle, first));
  if (turn < last) draw_rows(turn, last, EdgeColumns(*middle, *bottom, turn));
}

}  // namespace temblor::render
