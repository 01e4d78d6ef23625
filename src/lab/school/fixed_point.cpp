#include "lab/school/fixed_point.h"

#include <algorithm>
#include <utility>

namespace temblor::lab::school {
namespace {

struct FixedPoint {
  Fixed x, y;
};

// An edge from top to bottom, at the center of its current row.
struct FixedEdge {
  Fixed x, slope;

  FixedEdge(const FixedPoint& top, const FixedPoint& bottom, int row) {
    if (top.y.raw == bottom.y.raw) {
      x = top.x;
      return;
    }
    slope = (bottom.x - top.x) / (bottom.y - top.y);
    const Fixed center{(row << Fixed::kFractionBits) + (1 << (Fixed::kFractionBits - 1))};
    x = top.x + slope * (center - top.y);
  }
};

void add_rows(int begin_y, int end_y, FixedEdge a, FixedEdge b, std::vector<Span>& io_spans) {
  for (int y = begin_y; y < end_y; ++y) {
    const int begin = std::min(a.x.first_pixel(), b.x.first_pixel());
    const int end = std::max(a.x.first_pixel(), b.x.first_pixel());
    if (begin < end) io_spans.push_back({y, begin, end});
    a.x = a.x + a.slope;
    b.x = b.x + b.slope;
  }
}

}  // namespace

std::vector<Span> find_spans_in_fixed_point(Corners corners) {
  std::ranges::sort(corners, {}, [](const Point& point) { return std::pair(point.y, point.x); });
  std::array<FixedPoint, 3> fixed;
  for (std::size_t i = 0; i < 3; ++i) fixed[i] = {Fixed::from(corners[i].x), Fixed::from(corners[i].y)};
  const auto& [top, middle, bottom] = fixed;
  const int top_y = top.y.first_pixel(), middle_y = middle.y.first_pixel(), end_y = bottom.y.first_pixel();
  std::vector<Span> spans;
  add_rows(top_y, middle_y, {top, bottom, top_y}, {top, middle, top_y}, spans);
  add_rows(middle_y, end_y, {top, bottom, middle_y}, {middle, bottom, middle_y}, spans);
  return spans;
}

}  // namespace temblor::lab::school
