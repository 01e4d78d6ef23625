#include "lab/world_light/polygon_row.h"

#include <algorithm>
#include <cmath>

namespace temblor::lab {

void PolygonRow::find(std::span<const LitPolygon> polygons, int y) {
  y_ = y;
  count_ = 0;
  for (const LitPolygon& polygon : polygons)
    if (polygon.top <= y && y <= polygon.bottom && count_ < kMaxIntervals)
      intervals_[count_++] = {cross_row(polygon, y), &polygon};
  if (count_ == 0) {
    const auto distance = [&](const LitPolygon& p) { return std::max(p.top - y, y - p.bottom); };
    const LitPolygon& nearest = *std::ranges::min_element(polygons, {}, distance);
    intervals_[count_++] = {cross_row(nearest, y), &nearest};
  }
  // By their middles: a triangle without area lies at the edge of its neighbor.
  const auto middle = [](const RowInterval& interval) { return interval.row.left + interval.row.right; };
  std::ranges::sort(std::span(intervals_).first(count_), {}, middle);
}

void PolygonRow::split(const render::Span& span, base::FunctionRef<void(const RowPart&)> use) const {
  const int end = span.x + span.count;
  int x = span.x;
  for (std::size_t i = 0; i < count_ && x < end; ++i) {
    int next = end;
    if (i + 1 < count_)
      next = static_cast<int>(
          std::clamp(std::ceil(intervals_[i + 1].row.left), static_cast<double>(x), 1.0 * end));
    if (next == x) continue;
    use({intervals_[i], {static_cast<std::uint16_t>(x), span.y, static_cast<std::uint16_t>(next - x)}});
    x = next;
  }
}

}  // namespace temblor::lab
