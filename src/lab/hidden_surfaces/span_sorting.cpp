#include "lab/hidden_surfaces/span_sorting.h"

#include <algorithm>
#include <array>

#include "lab/hidden_surfaces/draw_order.h"
#include "lab/hidden_surfaces/surface_depths.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

// The input of all bands of a frame.
struct Scan {
  const render::EdgeTable& table;
  const SurfaceEdges& edges;
  std::span<const std::uint32_t> front_to_back;
  std::span<const std::uint32_t> rank;          // by surface: its place in front_to_back
  std::span<const render::ScreenPlane> depths;  // by surface; empty: compare ranks
  int width;
};

// A span in the bucket of a row: a linked list from left to right.
struct BucketSpan {
  std::int32_t first, end;
  std::uint32_t surface;
  std::uint32_t next;
};
constexpr std::uint32_t kNone = 0xffffffff;

class Buckets {
 public:
  Buckets(const Scan& scan, render::RowRange rows, base::Arena& arena)
      : scan_(scan),
        rows_(rows),
        heads_(arena.allocate_filled(static_cast<std::size_t>(rows.end - rows.first), kNone)),
        nodes_(arena, 4096) {}

  void add_surfaces(base::Arena& arena) {
    SurfaceScan surface_scan(scan_.table, scan_.edges, rows_, scan_.width, arena);
    for (const std::uint32_t surface : scan_.front_to_back) {
      if (surface == 0) continue;
      const render::RowRange rows = surface_scan.scan(surface);
      for (int row = rows.first; row < rows.end; ++row) insert(surface, row, surface_scan.span_at(row));
    }
  }

  // All spans; gaps show the background.
  std::span<const render::DrawSpan> collect(base::Arena& arena) const {
    base::ArenaVector<render::DrawSpan> spans(arena, nodes_.size() + heads_.size());
    for (int row = rows_.first; row < rows_.end; ++row) {
      std::int32_t x = 0;
      const auto add = [&](std::uint32_t draw, std::int32_t end) {
        if (x < end)
          spans.push_back({draw,
                           {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(row),
                            static_cast<std::uint16_t>(end - x)}});
        x = std::max(x, end);
      };
      for (std::uint32_t i = heads_[static_cast<std::size_t>(row - rows_.first)]; i != kNone;
           i = nodes_[i].next) {
        add(0, nodes_[i].first);
        add(scan_.table.surfaces[nodes_[i].surface].first_draw, nodes_[i].end);
      }
      add(0, scan_.width);
    }
    return spans.view();
  }

  Counts counts() const {
    Counts counts = counts_;
    counts.bytes = nodes_.size() * sizeof(BucketSpan) + heads_.size_bytes();
    return counts;
  }

 private:
  // Clips the new span and the bucket's spans against each other. `link` is where the next part belongs.
  void insert(std::uint32_t surface, int row, RowSpan pixels) {
    if (pixels.first >= pixels.end) return;
    ++counts_.spans_sorted;
    std::uint32_t previous = kNone;
    std::uint32_t here = heads_[static_cast<std::size_t>(row - rows_.first)];
    while (pixels.first < pixels.end) {
      while (here != kNone && nodes_[here].end <= pixels.first) {
        previous = here;
        here = nodes_[here].next;
      }
      // Up to the next span of the bucket, nothing hides the new one.
      const std::int32_t free_end = here == kNone ? pixels.end : std::min(pixels.end, nodes_[here].first);
      if (pixels.first < free_end) {
        previous = link(previous, here, row, {pixels.first, free_end, surface, here});
        pixels.first = free_end;
        continue;
      }
      const std::int32_t shared_end = std::min(pixels.end, nodes_[here].end);
      if (is_nearer(surface, nodes_[here].surface, pixels.first, shared_end, row))
        here = replace(here, row, {pixels.first, shared_end, surface, kNone});
      pixels.first = shared_end;
    }
  }

  // Inserts a node before `here`, and returns its number.
  std::uint32_t link(std::uint32_t previous, std::uint32_t here, int row, BucketSpan span) {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    span.next = here;
    nodes_.push_back(span);
    if (previous == kNone)
      heads_[static_cast<std::size_t>(row - rows_.first)] = number;
    else
      nodes_[previous].next = number;
    return number;
  }

  // Puts `span` over a part of node `here`, whose remains stay at its left and right. Returns the number of
  // the new node.
  std::uint32_t replace(std::uint32_t here, int row, BucketSpan span) {
    const BucketSpan hidden = nodes_[here];
    std::uint32_t after = hidden.next;
    if (span.end < hidden.end) {
      after = static_cast<std::uint32_t>(nodes_.size());
      nodes_.push_back({span.end, hidden.end, hidden.surface, hidden.next});
    }
    if (hidden.first < span.first) {
      nodes_[here].end = span.first;
      return link(here, after, row, span);
    }
    span.next = after;
    nodes_[here] = span;
    return here;
  }

  // Spans of different surfaces do not cross, so any shared pixel decides.
  bool is_nearer(std::uint32_t surface, std::uint32_t other, std::int32_t first, std::int32_t end, int row) {
    ++counts_.comparisons;
    if (!scan_.depths.empty()) {
      const double x = (first + end - 1) / 2.0;
      const double depth = scan_.depths[surface].at(x, row), other_depth = scan_.depths[other].at(x, row);
      if (depth != other_depth) return depth > other_depth;
    }
    return scan_.rank[surface] < scan_.rank[other];
  }

  const Scan& scan_;
  render::RowRange rows_;
  std::span<std::uint32_t> heads_;  // by row of the band: its first node
  base::ArenaVector<BucketSpan> nodes_;
  Counts counts_;
};

}  // namespace

render::FrameStages make_span_sorting(std::span<const double> values, Counter* counter) {
  render::FrameStages stages;
  const bool by_depth = values[0] != 0;
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    base::Arena& arena = context.arena();
    const SurfaceEdges edges = group_edges(context, table);
    const std::span<const std::uint32_t> back_to_front =
        order_back_to_front(context, table, edges, view.width);
    const std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(back_to_front.size());
    std::reverse_copy(back_to_front.begin(), back_to_front.end(), order.begin());
    const std::span<std::uint32_t> rank = arena.allocate<std::uint32_t>(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
    Scan scan{table, edges, order, rank, {}, view.width};
    if (by_depth) scan.depths = find_surface_depths(context, view, table);
    return render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena& band_arena) {
      Buckets buckets(scan, rows, band_arena);
      buckets.add_surfaces(band_arena);
      if (counter != nullptr) counter->add(buckets.counts());
      return buckets.collect(band_arena);
    });
  };
  return stages;
}

}  // namespace temblor::lab
