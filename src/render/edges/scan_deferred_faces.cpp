#include "render/edges/scan_deferred_faces.h"

#include <algorithm>

#include "render/edges/edge_crossing.h"

namespace temblor::render {

namespace {

// An edge where it crosses a row: going right, the face begins there or ends.
struct Crossing {
  double x;
  bool begins;
};

class LateScan {
 public:
  LateScan(int width, base::ArenaVector<ItemSpan>& out_spans, base::Arena& arena)
      : width_(width), spans_(out_spans), crossings_(arena, 16) {}

  void scan_row(std::span<const Edge> edges, int row, std::uint32_t item) {
    crossings_.clear();
    for (const Edge& edge : edges) {
      if (row < edge.first_row || row > edge.last_row) continue;
      const double x = crossing(edge.x_first, edge.step, row - edge.first_row);
      if (x <= width_ - 1) insert({x, edge.leading != kBackground});
    }
    // Faces need not be quite convex: what counts is how many of its edges a pixel is inside of.
    int inside = 0, begin = 0;
    for (const Crossing& crossed : crossings_) {
      if (crossed.begins && ++inside == 1) begin = first_pixel(crossed.x);
      if (!crossed.begins && --inside == 0) add(begin, first_pixel(crossed.x), row, item);
    }
    if (inside > 0) add(begin, width_, row, item);  // its end lies right of the screen
  }

 private:
  // Of edges in one place the last made comes first, as in the edge list.
  void insert(const Crossing& crossed) {
    crossings_.push_back(crossed);
    for (std::size_t i = crossings_.size() - 1; i > 0 && crossings_[i].x <= crossings_[i - 1].x; --i)
      std::swap(crossings_[i], crossings_[i - 1]);
  }
  void add(int begin, int end, int row, std::uint32_t item) {
    if (begin >= end) return;
    spans_.push_back({item,
                      {static_cast<std::uint16_t>(begin), static_cast<std::uint16_t>(row),
                       static_cast<std::uint16_t>(end - begin)}});
  }

  const int width_;
  base::ArenaVector<ItemSpan>& spans_;
  base::ArenaVector<Crossing> crossings_;  // of the row, from left to right
};

}  // namespace

std::span<const ItemSpan> with_deferred_faces(std::span<const ItemSpan> spans, const EdgeTable& table,
                                              int first_row, int row_count, int width, base::Arena& arena) {
  base::ArenaVector<ItemSpan> all(arena, spans.size() + 256);
  for (const ItemSpan& span : spans) all.push_back(span);
  LateScan scan(width, all, arena);
  for (std::size_t i = 0; i < table.deferred_count(); ++i) {
    const std::span<const Edge> edges = table.deferred_edges.subspan(
        table.deferred_edge_begin[i], table.deferred_edge_begin[i + 1] - table.deferred_edge_begin[i]);
    int top = first_row + row_count, bottom = first_row - 1;
    for (const Edge& edge : edges) {
      top = std::min(top, edge.first_row);
      bottom = std::max(bottom, edge.last_row);
    }
    for (int row = std::max(top, first_row); row <= std::min(bottom, first_row + row_count - 1); ++row)
      scan.scan_row(edges, row, table.surfaces[table.first_late() + i].first_item);
  }
  return all.view();
}

}  // namespace temblor::render
