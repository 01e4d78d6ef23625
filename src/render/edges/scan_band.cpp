// Hot loop. Abrash, "Sorted Spans in Action": on each scan line the active edges are walked from left to
// right, and a stack of surfaces, sorted by key, tells which is in front; when that changes, a span ends.
//
// Edges at one pixel may be met in any order: a surface counts the edges that it is inside of, and a span
// that would be empty is not made. Their order is total all the same, for the sake of brush models that
// touch.
#include "render/edges/scan_band.h"

#include <algorithm>
#include <cmath>

namespace temblor::render {

namespace {

struct ActiveEdge {
  double x;  // on this row; 0 when left of the screen
  double x_first, step;
  std::uint32_t number;
  std::int32_t first_row, last_row;
  SurfaceIndex leading, trailing;

  // A total order, so that it does not matter where a band began. Of edges in one place the last made comes
  // first: it is most often the farthest surface's, and what begins nearer goes on top of the stack.
  bool before(const ActiveEdge& other) const {
    return x < other.x || (x == other.x && number > other.number);
  }
};

// A surface's place in the stack on the row being scanned.
struct StackEntry {
  std::int32_t row = -1;    // the row that the rest is about
  std::int32_t inside = 0;  // leading edges passed, less trailing ones
  std::uint32_t nearer = 0, farther = 0;
  SortKey key = 0;
  std::uint32_t piece = 0;
};

// The first pixel whose centre is not left of x, from 0 on. (std::ceil is a call on processors without
// SSE 4.1.)
int first_pixel(double x) {
  const int whole = static_cast<int>(x);
  return whole + (x > whole ? 1 : 0);
}

class BandScan {
 public:
  BandScan(const EdgeTable& table, int width, base::Arena& arena, base::ArenaVector<ScannedSpan>& io_spans)
      : table_(table),
        width_(width),
        spans_(io_spans),
        active_(arena, 512),
        stack_(arena.allocate<StackEntry>(table.surfaces.size())) {
    for (std::size_t i = 0; i < stack_.size(); ++i) {
      stack_[i] = StackEntry{};
      stack_[i].key = table.surfaces[i].key;
      stack_[i].piece = table.surfaces[i].piece;
    }
  }

  // Edges that began above the band.
  void enter_running_edges(int row) {
    const std::uint32_t begun = table_.row_begin[static_cast<std::size_t>(row)];
    for (std::uint32_t i = 0; i < begun; ++i)
      if (table_.edges[table_.order[i]].last_row >= row) enter(table_.order[i]);
  }

  void scan_row(int row) {
    for (std::uint32_t i = table_.row_begin[static_cast<std::size_t>(row)];
         i < table_.row_begin[static_cast<std::size_t>(row) + 1]; ++i)
      enter(table_.order[i]);
    advance_to(row);
    row_ = row;
    top_ = kBottom;
    span_start_ = 0;
    stack_[kBottom] = {row, 1, kBottom, kBottom, stack_[kBottom].key, 0};
    for (const ActiveEdge& edge : active_) {
      if (edge.x > width_ - 1) break;
      const int pixel = first_pixel(edge.x);
      if (edge.trailing != kBackground) leave(static_cast<std::uint32_t>(edge.trailing), pixel);
      if (edge.leading != kBackground) begin(static_cast<std::uint32_t>(edge.leading), pixel, edge.x);
    }
    end_span(width_);
  }

 private:
  // Relative. The original allows one part in a hundred, and takes faces for touching that stand well apart.
  static constexpr double kTouching = 1e-5;
  static constexpr std::uint32_t kBottom = 0;  // the background's place in the stack

  void enter(std::uint32_t number) {
    const Edge& edge = table_.edges[number];
    active_.push_back(
        {0, edge.x_first, edge.step, number, edge.first_row, edge.last_row, edge.leading, edge.trailing});
  }

  // Drops edges that have ended and sorts the rest where they cross this row. From one row to the next few
  // change places, so insertion it is, unless many have just begun.
  void advance_to(int row) {
    constexpr std::size_t kMostInserted = 16;
    const bool sort_all = active_.size() > sorted_ + kMostInserted;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      if (active_[i].last_row < row) continue;
      if (kept != i) active_[kept] = active_[i];
      ActiveEdge& edge = active_[kept];
      edge.x = std::max(edge.x_first + edge.step * (row - edge.first_row), 0.0);
      if (!sort_all && kept > 0 && edge.before(active_[kept - 1])) insert_before(kept);
      ++kept;
    }
    active_.shrink(kept);
    if (sort_all)
      std::sort(active_.begin(), active_.end(),
                [](const ActiveEdge& a, const ActiveEdge& b) { return a.before(b); });
    sorted_ = kept;
  }

  void insert_before(std::size_t place) {
    const ActiveEdge edge = active_[place];
    for (; place > 0 && edge.before(active_[place - 1]); --place) active_[place] = active_[place - 1];
    active_[place] = edge;
  }

  void end_span(int pixel) {
    if (pixel > span_start_)
      spans_.push_back({static_cast<SurfaceIndex>(top_), static_cast<std::uint16_t>(span_start_),
                        static_cast<std::uint16_t>(row_), static_cast<std::uint16_t>(pixel - span_start_)});
    span_start_ = pixel;
  }

  StackEntry& entry(std::uint32_t surface) {
    StackEntry& found = stack_[surface];
    if (found.row != row_) {
      found.row = row_;
      found.inside = 0;
    }
    return found;
  }

  void leave(std::uint32_t surface, int pixel) {
    StackEntry& left = entry(surface);
    if (--left.inside != 0) return;
    if (surface == top_) {
      end_span(pixel);
      top_ = left.farther;
    } else {
      stack_[left.nearer].farther = left.farther;
      stack_[left.farther].nearer = left.nearer;
    }
  }

  void begin(std::uint32_t surface, int pixel, double edge_x) {
    StackEntry& begun = entry(surface);
    if (++begun.inside != 1) return;
    std::uint32_t below = top_;
    if (in_front(begun, stack_[below], edge_x)) {
      end_span(pixel);
      begun.farther = top_;
      stack_[top_].nearer = surface;
      top_ = surface;
      return;
    }
    do below = stack_[below].farther;
    while (!in_front(begun, stack_[below], edge_x));
    begun.farther = below;
    begun.nearer = stack_[below].nearer;
    stack_[begun.nearer].farther = surface;
    stack_[below].nearer = surface;
  }

  // Brush models in one leaf have the same key: the nearer one is in front, and where two touch at the edge
  // that begins, the one that comes nearer towards the right, or was entered first.
  bool in_front(const StackEntry& begun, const StackEntry& other, double x) const {
    if (begun.key != other.key) return begun.key < other.key;
    const ScreenPlane& plane = table_.pieces[begun.piece].depth;
    const ScreenPlane& other_plane = table_.pieces[other.piece].depth;
    const double depth = plane.at(x, row_), other_depth = other_plane.at(x, row_);
    // Orthographic depths are negative, so the tolerance goes by the size of the number.
    const double tolerance = kTouching * std::abs(depth);
    if (depth - tolerance >= other_depth) return true;
    if (depth + tolerance < other_depth) return false;
    return plane.dx > other_plane.dx || (plane.dx == other_plane.dx && &begun < &other);
  }

  const EdgeTable& table_;
  const int width_;
  base::ArenaVector<ScannedSpan>& spans_;
  base::ArenaVector<ActiveEdge> active_;
  std::size_t sorted_ = 0;  // of active_: those of the row before
  std::span<StackEntry> stack_;
  int row_ = 0;
  std::uint32_t top_ = kBottom;
  int span_start_ = 0;
};

}  // namespace

void scan_band(const EdgeTable& table, int first_row, int row_count, int width, base::Arena& arena,
               base::ArenaVector<ScannedSpan>& io_spans) {
  BandScan scan(table, width, arena, io_spans);
  scan.enter_running_edges(first_row);
  for (int row = first_row; row < first_row + row_count; ++row) scan.scan_row(row);
}

}  // namespace temblor::render
