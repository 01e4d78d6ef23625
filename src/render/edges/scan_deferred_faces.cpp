#include "render/edges/scan_deferred_faces.h"

#include <algorithm>

#include "render/edges/edge_crossing.h"

namespace temblor::render {

namespace {

// The point where an edge crosses a row: from left to right, the face begins or ends there.
struct Crossing {
  double x;
  bool begins;
};

class DeferredScan {
 public:
  DeferredScan(int width, base::ArenaVector<DrawSpan>& out_spans, base::Arena& arena)
      : width_(width), spans_(out_spans), crossings_(arena, 16) {}

  void scan_row(std::span<const Edge> edges, int row, std::uint32_t draw) {
    crossings_.clear();
    for (const Edge& edge : edges) {
      if (row < edge.first_row || row > edge.last_row) continue;
      const double x = crossing(edge.x_first, edge.step, row - edge.first_row);
      if (x <= width_ - 1) insert({x, edge.leading != kBackground});
    }
    // Projected faces may be slightly concave, so the edges that a pixel is inside of are counted.
    int inside = 0, begin = 0;
    for (const Crossing& crossed : crossings_) {
      if (crossed.begins && ++inside == 1) begin = first_pixel(crossed.x);
      if (!crossed.begins && --inside == 0) add(begin, first_pixel(crossed.x), row, draw);
    }
    if (inside > 0) add(begin, width_, row, draw);  // its end lies right of the screen
  }

 private:
  // Among edges at the same place the last one comes first, as in the active edge list.
  void insert(const Crossing& crossed) {
    crossings_.push_back(crossed);
    for (std::size_t i = crossings_.size() - 1; i > 0 && crossings_[i].x <= crossings_[i - 1].x; --i)
      std::swap(crossings_[i], crossings_[i - 1]);
  }
  void add(int begin, int end, int row, std::uint32_t draw) {
    if (begin >= end) return;
    spans_.push_back({draw,
                      {static_cast<std::uint16_t>(begin), static_cast<std::uint16_t>(row),
                       static_cast<std::uint16_t>(end - begin)}});
  }

  const int width_;
  base::ArenaVector<DrawSpan>& spans_;
  base::ArenaVector<Crossing> crossings_;  // of the row, from left to right
};

}  // namespace

std::span<const DrawSpan> add_deferred_faces(std::span<const DrawSpan> spans, const EdgeTable& table,
                                             RowRange rows, int width, base::Arena& arena) {
  base::ArenaVector<DrawSpan> all(arena, spans.size() + 256);
  for (const DrawSpan& span : spans) all.push_back(span);
  DeferredScan scan(width, all, arena);
  for (std::size_t i = 0; i < table.deferred_count(); ++i) {
    const std::span<const Edge> edges = table.deferred_edges.subspan(
        table.deferred_edge_begin[i], table.deferred_edge_begin[i + 1] - table.deferred_edge_begin[i]);
    int top = rows.end, bottom = rows.first - 1;
    for (const Edge& edge : edges) {
      top = std::min(top, edge.first_row);
      bottom = std::max(bottom, edge.last_row);
    }
    for (int row = std::max(top, rows.first); row <= std::min(bottom, rows.end - 1); ++row)
      scan.scan_row(edges, row, table.surfaces[table.first_deferred() + i].first_draw);
  }
  return all.view();
}

}  // namespace temblor::render
