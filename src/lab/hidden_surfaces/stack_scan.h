// The scan of a band with a DepthStack, row by row. Rows do not reuse what the row above found out.
#pragma once

#include <span>

#include "lab/hidden_surfaces/depth_stack.h"
#include "render/edges/edge_crossing.h"
#include "render/edges/scan_band.h"

namespace temblor::lab {

// The spans of a band, row by row from left to right.
class RowSpans {
 public:
  RowSpans(const render::EdgeTable& table, int width, base::Arena& arena)
      : table_(table), width_(width), spans_(arena, 4096) {}

  void begin_row(int row) {
    row_ = row;
    begin_ = 0;
  }
  // The surface covers the pixels from the end of the span before up to `end` - 1.
  void add(render::SurfaceIndex surface, int end) {
    if (end <= begin_) return;
    const std::uint32_t draw = table_.surfaces[base::to_size(surface)].first_draw;
    const auto count = static_cast<std::uint16_t>(end - begin_);
    if (begin_ > 0 && spans_.back().draw == draw)
      spans_.back().span.count = static_cast<std::uint16_t>(spans_.back().span.count + count);
    else
      spans_.push_back({draw, {static_cast<std::uint16_t>(begin_), static_cast<std::uint16_t>(row_), count}});
    begin_ = end;
  }
  int width() const { return width_; }
  std::span<const render::DrawSpan> all() const { return spans_.view(); }

 private:
  const render::EdgeTable& table_;
  const int width_;
  base::ArenaVector<render::DrawSpan> spans_;
  int row_ = 0, begin_ = 0;
};

// The edges that are not right of the screen.
inline std::size_t count_on_screen(std::span<const double> x, int width) {
  std::size_t count = x.size();
  while (count > 0 && x[count - 1] > width - 1) --count;
  return count;
}

// The spans of `rows`, each row's from left to right. They live in `arena`.
template <typename Order>
std::span<const render::DrawSpan> scan_with_stack(const render::EdgeTable& table, render::RowRange rows,
                                                  int width, DepthStack<Order>& io_stack,
                                                  base::Arena& arena) {
  render::ActiveEdges edges(table, rows.first, arena);
  base::ArenaVector<DepthStackSwitch> switches(arena, 512);
  RowSpans spans(table, width, arena);
  for (int row = rows.first; row < rows.end; ++row) {
    edges.advance_to(row);
    const std::size_t count = count_on_screen(edges.x(), width);
    io_stack.walk(row, edges.x().first(count), edges.records().first(count), switches);
    spans.begin_row(row);
    render::SurfaceIndex front = render::kBackground;
    for (const DepthStackSwitch& change : switches) {
      spans.add(front, render::first_pixel(edges.x()[change.place]));
      front = change.surface;
    }
    spans.add(front, width);
  }
  return spans.all();
}

}  // namespace temblor::lab
