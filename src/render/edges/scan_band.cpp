// Hot loop. Abrash, "Sorted Spans in Action": on each scan line the active edges are walked from left to
// right, and a stack of surfaces, sorted by key, tells which is in front; when that changes, a span ends.
//
// Which edges those are where it changes, and what is in front from there on, is the same on every row that
// the same edges cross in the same order; only the pixels differ. Such rows are not walked again.
//
// Edges at one pixel may be met in any order: a surface counts the edges that it is inside of, and a span
// that would be empty is not made. Their order is total all the same, for the sake of brush models that
// touch.
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
  std::span<const ItemSpan> spans() const { return spans_.view(); }

 private:
  // Edges not right of the screen.
  std::size_t count_on_screen() const {
    const std::span<const double> x = edges_.x();
    std::size_t count = x.size();
    while (count > 0 && x[count - 1] > width_ - 1) --count;
    return count;
  }

  void walk(int row, std::size_t on_screen) {
    stack_.walk(row, edges_.x().first(on_screen), edges_.marks().first(on_screen), switches_);
    walked_ = on_screen;
  }

  void add_spans(std::uint16_t row) {
    const std::span<const double> x = edges_.x();
    ItemSpan* next = spans_.extend(switches_.size() + 1);
    std::uint32_t item = 0;
    int begin = 0;
    const auto add = [&](int end) {
      *next = {item, {static_cast<std::uint16_t>(begin), row, static_cast<std::uint16_t>(end - begin)}};
      next += end > begin;  // empty ones are written over
      begin = end;
    };
    for (const SurfaceStack::Switch& change : switches_) {
      add(first_pixel(x[change.place]));
      item = change.item;
    }
    add(width_);
    spans_.shrink(static_cast<std::size_t>(next - spans_.data()));
  }

  const int width_;
  ActiveEdges edges_;
  SurfaceStack stack_;
  base::ArenaVector<SurfaceStack::Switch> switches_;  // of the last walk
  std::size_t walked_ = 0;                            // edges that it passed
  base::ArenaVector<ItemSpan> spans_;
};

}  // namespace

std::span<const ItemSpan> scan_band(const EdgeTable& table, const SurfaceRanks& ranks, int first_row,
                                    int row_count, int width, base::Arena& arena) {
  BandScan scan(table, ranks, first_row, width, arena);
  for (int row = first_row; row < first_row + row_count; ++row) scan.scan_row(row);
  return scan.spans();
}

}  // namespace temblor::render
