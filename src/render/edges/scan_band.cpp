// Hot loop. On each scan line the active edges are passed from left to right, and the surface stack says
// which surface is in front; where that changes, a span ends (Abrash, "Sorted Spans in Action").
//
// On consecutive rows that are crossed by the same edges in the same order, the same edges change the front
// surface and only their pixels differ. Such rows reuse the previous walk; most rows do.
//
// Edges at the same pixel may be passed in any order: a surface counts the edges that it is inside of, and
// empty spans are dropped. The order is total anyway, because brush models that touch depend on it.
#include "render/edges/scan_band.h"

#include "render/edges/active_edges.h"
#include "render/edges/edge_crossing.h"

namespace temblor::render {

namespace {

class BandScan {
 public:
  BandScan(const EdgeTable& table, const SurfaceRanks& ranks, int first_row, int width, base::Arena& arena)
      : width_(width),
        edges_(table, first_row, arena),
        stack_(table, ranks, arena),
        switches_(arena, 512),
        spans_(arena, 4096) {}

  void scan_row(int row) {
    const bool same_edges = edges_.advance_to(row);
    const std::size_t on_screen = count_on_screen();
    if (!same_edges || on_screen != walked_ || !stack_.comparisons_hold(row, edges_.x()))
      walk(row, on_screen);
    add_spans(static_cast<std::uint16_t>(row));
  }
  std::span<const DrawSpan> spans() const { return spans_.view(); }

 private:
  // The number of edges that are not right of the screen; later ones are not walked.
  std::size_t count_on_screen() const {
    const std::span<const double> x = edges_.x();
    std::size_t count = x.size();
    while (count > 0 && x[count - 1] > width_ - 1) --count;
    return count;
  }

  void walk(int row, std::size_t on_screen) {
    stack_.walk(row, edges_.x().first(on_screen), edges_.records().first(on_screen), switches_);
    walked_ = on_screen;
  }

  // Turns the switches into spans. The span before the first switch shows the background (draw 0).
  void add_spans(std::uint16_t row) {
    const std::span<const double> x = edges_.x();
    DrawSpan* next = spans_.extend(switches_.size() + 1);
    std::uint32_t draw = 0;
    int begin = 0;
    const auto add = [&](int end) {
      *next = {draw, {static_cast<std::uint16_t>(begin), row, static_cast<std::uint16_t>(end - begin)}};
      next += end > begin;  // empty ones are written over
      begin = end;
    };
    for (const SurfaceStack::Switch& change : switches_) {
      add(first_pixel(x[change.place]));
      draw = change.draw;
    }
    add(width_);
    spans_.shrink(static_cast<std::size_t>(next - spans_.data()));
  }

  const int width_;
  ActiveEdges edges_;
  SurfaceStack stack_;
  base::ArenaVector<SurfaceStack::Switch> switches_;  // of the last walk
  std::size_t walked_ = 0;                            // edges that it passed
  base::ArenaVector<DrawSpan> spans_;
};

}  // namespace

std::span<const DrawSpan> scan_band(const EdgeTable& table, const SurfaceRanks& ranks, RowRange rows,
                                    int width, base::Arena& arena) {
  BandScan scan(table, ranks, rows.first, width, arena);
  for (int row = rows.first; row < rows.end; ++row) scan.scan_row(row);
  return scan.spans();
}

}  // namespace temblor::render
