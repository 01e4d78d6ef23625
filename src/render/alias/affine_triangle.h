// Rasterizes one triangle, scan line by scan line: the scalar reference. Not to be included in kernels that
// are compiled for several processors, because it has function bodies.
//
//             top                    Corners lie at multiples of 1/256 pixel. The first pixel right of an
//             /|                     edge is the quotient of two integers below 2^53, rounded up, and a
//      whole / | part                division in double finds it exactly.
//           /  |
//          /   middle                A pixel whose center is on a left or top edge is inside, one on a right
//         /  _/                      or bottom edge is outside: triangles that share an edge cover each
//        / _/  part                  pixel along it exactly once.
//       /_/
//      bottom
//
// Depth, texels, and light are linear on the screen. Their gradients share a denominator, the cross product
// of two sides, whose sign also identifies back faces and degenerate triangles.
//
// Like stock Quake, small triangles map textures affinely (Abrash, "Quake's 3-D Engine: The Big Picture").
// Unlike it, triangles for which that would show are drawn in perspective.
#pragma once

#include <array>
#include <cstdint>

#include "render/alias/triangle_kernels.h"

namespace temblor::render {

// Steps along an edge: for each row, the first pixel whose center is not left of the edge.
class EdgeColumns {
 public:
  // `lower` must be at least one step below `upper`. `row` is the first row that next() is called for.
  EdgeColumns(const ScreenVertex& upper, const ScreenVertex& lower, std::int32_t row) {
    const std::int64_t dx = std::int64_t{lower.x} - upper.x, dy = std::int64_t{lower.y} - upper.y;
    numerator_ = static_cast<double>(upper.x * dy + (std::int64_t{row} * kSubpixels - upper.y) * dx);
    step_ = static_cast<double>(dx * kSubpixels);
    denominator_ = static_cast<double>(dy * kSubpixels);
  }
  // Clamped to 0 and `width`.
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

// A linear function over the screen, given by its value at the triangle's first corner.
struct ScreenGradient {
  double at_corner, dx, dy;  // dx, dy: per pixel
};

// The values that are interpolated over a triangle. In perspective, s and t are multiplied by depth.
struct TriangleGradients {
  ScreenGradient depth, light, s, t;
  bool perspective;
  double corner_x, corner_y;  // pixels
};

// The pixels of a triangle in one row.
struct TriangleSpan {
  std::int32_t x, y, count;
  float depth, light, s, t;  // at its first pixel
  float depth_step, light_step, s_step, t_step;
  bool perspective;
};

// Whether affine texels would be off by more than kAffineErrorTexels.
inline bool needs_perspective(const ScreenVertex* const corner[3], const TexelPoint* const texel[3]) {
  const auto range = [](float a, float b, float c, float& out_min) {
    const float least = a < b ? (a < c ? a : c) : (b < c ? b : c);
    const float most = a > b ? (a > c ? a : c) : (b > c ? b : c);
    out_min = least;
    return most - least;
  };
  float farthest, unused;
  const float depth_range = range(corner[0]->depth, corner[1]->depth, corner[2]->depth, farthest);
  const float s_range = range(texel[0]->s, texel[1]->s, texel[2]->s, unused);
  const float t_range = range(texel[0]->t, texel[1]->t, texel[2]->t, unused);
  // Halfway between two points whose 1/z has the ratio r, an affine coordinate is off by about (r - 1) / 4 of
  // its range.
  return (s_range > t_range ? s_range : t_range) * depth_range > 4 * kAffineErrorTexels * farthest;
}

// `cross` must be positive: twice the area, in squared subpixels.
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

inline TriangleSpan span_at(const TriangleGradients& gradients, std::int32_t x, std::int32_t y,
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

// 1/z is larger on visible triangles, but rounding may bring it to 0: divisions use at least this.
constexpr float kMinDepth = 1e-20f;

// The palette index that a pixel of the span shows.
inline std::uint8_t skin_texel(const TriangleJob& job, const TriangleSpan& span, float lane, float depth) {
  float s = span.s + lane * span.s_step, t = span.t + lane * span.t_step;
  if (span.perspective) {
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

inline std::int32_t span_light(const TriangleSpan& span, float lane, float most) {
  const float light = span.light + lane * span.light_step;
  const float bounded = light < most ? light : most;
  return static_cast<std::int32_t>(bounded > 0 ? bounded : 0);
}

// A lit texel. The last parameter only selects the overload for the pixel format.
inline std::uint8_t lit_texel(const TriangleJob& job, std::uint8_t texel, const TriangleSpan& span,
                              float lane, std::uint8_t) {
  const std::int32_t light = span_light(span, lane, kDarkestRow);
  return static_cast<const std::uint8_t*>(job.colors)[(light & ~255) + texel];
}
// Rgb: a color of the job in a light of 0 to kBrightestLight.
inline std::uint32_t lit_color(const TriangleJob& job, std::uint32_t color, std::int32_t light) {
  if (color >> 24 == 0) return color | 0xff000000u;
  std::uint32_t lit = 0xff000000u;
  for (int channel = 0; channel < 3; ++channel) {
    const int shift = 16 - 8 * channel;
    const std::int32_t tinted = (light * job.tint[channel]) >> 15;
    const std::int32_t value = (static_cast<std::int32_t>(color >> shift & 255) * 2 * tinted + 16384) >> 15;
    lit |= static_cast<std::uint32_t>(value < 255 ? value : 255) << shift;
  }
  return lit;
}
inline std::uint32_t lit_texel(const TriangleJob& job, std::uint8_t texel, const TriangleSpan& span,
                               float lane, std::uint32_t) {
  return lit_color(job, static_cast<const std::uint32_t*>(job.colors)[texel],
                   span_light(span, lane, kBrightestLight));
}

// Calls draw_span(span) for each row in which the triangle has pixels, from top to bottom. Never calls it for
// back faces and triangles without area.
template <typename DrawSpan>
void draw_affine_triangle(const TriangleJob& job, std::size_t number, const TriangleTarget& target,
                          DrawSpan draw_span) {
  const std::uint32_t* index = job.triangles + number * 3;
  const ScreenVertex* const corner[3] = {job.vertices + index[0], job.vertices + index[1],
                                         job.vertices + index[2]};
  const std::int64_t cross =
      (std::int64_t{corner[1]->x} - corner[0]->x) * (std::int64_t{corner[2]->y} - corner[0]->y) -
      (std::int64_t{corner[2]->x} - corner[0]->x) * (std::int64_t{corner[1]->y} - corner[0]->y);
  if (cross <= 0) return;

  // Sorts the corners from top to bottom. Each swap reverses their orientation, which tells on which side of
  // the long edge the middle corner is.
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
  const bool perspective = job.perspective && (job.always_perspective || needs_perspective(corner, texel));
  const TriangleGradients gradients =
      triangle_gradients(corner, texel, static_cast<double>(cross), perspective);
  const double width = target.width;
  EdgeColumns whole(*top, *bottom, first);
  const auto draw_rows = [&](std::int32_t begin, std::int32_t end, EdgeColumns part) {
    for (std::int32_t y = begin; y < end; ++y) {
      const std::int32_t a = whole.next(width), b = part.next(width);
      const std::int32_t begin_x = middle_is_right ? a : b, end_x = middle_is_right ? b : a;
      if (begin_x < end_x) draw_span(span_at(gradients, begin_x, y, end_x - begin_x));
    }
  };
  if (first < turn) draw_rows(first, turn, EdgeColumns(*top, *middle, first));
  if (turn < last) draw_rows(turn, last, EdgeColumns(*middle, *bottom, turn));
}

}  // namespace temblor::render
