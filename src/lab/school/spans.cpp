#include "lab/school/spans.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab::school {
namespace {

// The first pixel whose center is at `edge` or beyond.
int first_pixel(float edge) {
  return static_cast<int>(std::ceil(edge - 0.5f));
}

float cross_edge(const Point& top, const Point& bottom, float y) {
  return interpolate(top.x, bottom.x, (y - top.y) / (bottom.y - top.y));
}

}  // namespace

// From the top corner, one side of the triangle is the long edge to the bottom corner, and the other side is
// two short edges that meet at the middle corner.
std::vector<Span> find_spans(Corners corners, int width, int height) {
  std::ranges::sort(corners, {}, [](const Point& point) { return std::pair(point.y, point.x); });
  const auto& [top, middle, bottom] = corners;
  const int begin_y = std::max(first_pixel(std::max(top.y, -1.0f)), 0);
  const int end_y = std::min(first_pixel(std::min(bottom.y, static_cast<float>(height))), height);
  std::vector<Span> spans;
  for (int y = begin_y; y < end_y; ++y) {
    const float center_y = static_cast<float>(y) + 0.5f;
    const float long_x = cross_edge(top, bottom, center_y);
    const float short_x =
        center_y < middle.y ? cross_edge(top, middle, center_y) : cross_edge(middle, bottom, center_y);
    const auto inside = [&](float x) { return std::clamp(x, -1.0f, static_cast<float>(width) + 1); };
    const int begin = std::max(first_pixel(inside(std::min(long_x, short_x))), 0);
    const int end = std::min(first_pixel(inside(std::max(long_x, short_x))), width);
    if (begin < end) spans.push_back({y, begin, end});
  }
  return spans;
}

// Two equations, one for each edge from the first corner, for the two unknowns per_x and per_y.
Gradient find_gradient(const Corners& corners, const std::array<float, 3>& values) {
  const float x1 = corners[1].x - corners[0].x, y1 = corners[1].y - corners[0].y;
  const float x2 = corners[2].x - corners[0].x, y2 = corners[2].y - corners[0].y;
  const float twice_area = x1 * y2 - x2 * y1;
  if (twice_area == 0) return {values[0], 0, 0};
  const float v1 = values[1] - values[0], v2 = values[2] - values[0];
  Gradient gradient;
  gradient.per_x = (v1 * y2 - v2 * y1) / twice_area;
  gradient.per_y = (v2 * x1 - v1 * x2) / twice_area;
  gradient.at_origin = values[0] - gradient.per_x * corners[0].x - gradient.per_y * corners[0].y;
  return gradient;
}

}  // namespace temblor::lab::school
