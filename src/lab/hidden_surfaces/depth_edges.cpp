#include "lab/hidden_surfaces/depth_edges.h"

#include <memory>

#include "lab/hidden_surfaces/depth_stack.h"
#include "lab/hidden_surfaces/pair_orders.h"
#include "lab/hidden_surfaces/stack_scan.h"
#include "lab/hidden_surfaces/surface_depths.h"
#include "render/edges/active_edges.h"
#include "render/edges/edge_crossing.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

using render::DrawSpan;
using render::SurfaceIndex;

// Compares surfaces where one begins. `make_order` makes the stack's order of a frame.
template <typename MakeOrder>
render::FrameStages make_stack_stages(MakeOrder make_order, Counter* counter) {
  render::FrameStages stages;
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    const std::span<const render::ScreenPlane> depths = find_surface_depths(context, view, table);
    const auto order = make_order(context, table, depths);
    if (counter != nullptr) counter->add({.bytes = depths.size_bytes()});
    return render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena& arena) {
      DepthStack stack(order, depths.size(), arena);
      const std::span<const DrawSpan> spans = scan_with_stack(table, rows, view.width, stack, arena);
      if (counter != nullptr) counter->add(stack.order().counts());
      return spans;
    });
  };
  return stages;
}

render::FrameStages make_depth_stages(const DepthRule& rule, Counter* counter) {
  return make_stack_stages(
      [=](const render::FrameContext&, const render::EdgeTable&,
          std::span<const render::ScreenPlane> depths) { return DepthOrder(depths, rule); },
      counter);
}

// Compares all surfaces that cover an interval between two edges, and splits the interval where they cross.
class IntersectingScan {
 public:
  IntersectingScan(const render::EdgeTable& table, std::span<const render::ScreenPlane> depths, int first_row,
                   int width, base::Arena& arena)
      : depths_(depths),
        edges_(table, first_row, arena),
        passed_(arena.allocate_filled<Passed>(depths.size(), {-1, 0})),
        covering_(arena, 64),
        spans_(table, width, arena) {}

  void scan_row(int row) {
    edges_.advance_to(row);
    const std::span<const double> x = edges_.x();
    const std::size_t count = count_on_screen(x, spans_.width());
    covering_.clear();
    spans_.begin_row(row);
    int begin = 0;
    for (std::size_t place = 0; place < count; ++place) {
      const int end = render::first_pixel(x[place]);
      if (end > begin) add_interval(begin, end, row);
      begin = std::max(begin, end);
      pass(edges_.records()[place], row);
    }
    add_interval(begin, spans_.width(), row);
  }
  std::span<const DrawSpan> spans() const { return spans_.all(); }
  std::uint64_t comparisons() const { return comparisons_; }

 private:
  struct Passed {
    std::int32_t row, inside;
  };

  std::int32_t& inside(SurfaceIndex surface, int row) {
    Passed& found = passed_[base::to_size(surface)];
    if (found.row != row) found = {row, 0};
    return found.inside;
  }

  void pass(const render::EdgeRecord& record, int row) {
    if (record.trailing != render::kBackground && --inside(record.trailing, row) == 0) {
      *std::find(covering_.begin(), covering_.end(), record.trailing) = covering_.back();
      covering_.pop_back();
    }
    if (record.leading != render::kBackground && ++inside(record.leading, row) == 1)
      covering_.push_back(record.leading);
  }

  // Depths are compared at pixel centers. Equal depths are decided by the gradient, and equal gradients by
  // the surface's number.
  bool is_nearer(SurfaceIndex a, SurfaceIndex b, int x, int row) {
    ++comparisons_;
    const render::ScreenPlane &plane = depths_[base::to_size(a)], &other = depths_[base::to_size(b)];
    const double depth = plane.at(x, row), other_depth = other.at(x, row);
    if (depth != other_depth) return depth > other_depth;
    return plane.dx != other.dx ? plane.dx > other.dx : a < b;
  }

  void add_interval(int begin, int end, int row) {
    while (begin < end) {
      SurfaceIndex front = render::kBackground;
      for (const SurfaceIndex surface : covering_)
        if (front == render::kBackground || is_nearer(surface, front, begin, row)) front = surface;
      int next = end;
      const render::ScreenPlane& plane = depths_[base::to_size(front)];
      for (const SurfaceIndex surface : covering_)
        next = std::min(next, find_crossing(plane, surface, {begin, next}, row));
      spans_.add(front, next);
      begin = next;
    }
  }

  // The first pixel after range.first at which the surface is nearer than `plane`; range.end if there is
  // none.
  struct Range {
    int first, end;
  };
  int find_crossing(const render::ScreenPlane& plane, SurfaceIndex surface, Range range, int row) const {
    const render::ScreenPlane& other = depths_[base::to_size(surface)];
    const double gain = other.dx - plane.dx;
    if (!(gain > 0)) return range.end;
    const double behind = plane.at(range.first, row) - other.at(range.first, row);
    const double pixels = std::floor(behind / gain) + 1;
    return pixels < range.end - range.first ? range.first + std::max(1, static_cast<int>(pixels)) : range.end;
  }

  std::span<const render::ScreenPlane> depths_;
  render::ActiveEdges edges_;
  std::span<Passed> passed_;                  // by surface
  base::ArenaVector<SurfaceIndex> covering_;  // the current pixel
  RowSpans spans_;
  std::uint64_t comparisons_ = 0;
};

// The rule of abutting-edges, for pairs whose order is not in the cache.
constexpr DepthRule kCachedRule{.epsilon = 1e-5, .uses_gradient = true, .keeps_mesh = true};

}  // namespace

render::FrameStages make_independent_edges(std::span<const double> /*values*/, Counter* counter) {
  return make_depth_stages({.epsilon = 0, .uses_gradient = false, .keeps_mesh = true}, counter);
}

render::FrameStages make_abutting_edges(std::span<const double> values, Counter* counter) {
  return make_depth_stages(
      {.epsilon = values[0], .uses_gradient = values[1] != 0, .keeps_mesh = values[2] != 0}, counter);
}

render::FrameStages make_intersecting_edges(std::span<const double> /*values*/, Counter* counter) {
  render::FrameStages stages;
  stages.scan_edges = [=](const render::FrameContext& context, const render::ViewFrame& view,
                          const render::EdgeTable& table) {
    const std::span<const render::ScreenPlane> depths = find_surface_depths(context, view, table);
    if (counter != nullptr) counter->add({.bytes = depths.size_bytes()});
    return render::make_span_table(context, view, table, [&](render::RowRange rows, base::Arena& arena) {
      IntersectingScan scan(table, depths, rows.first, view.width, arena);
      for (int row = rows.first; row < rows.end; ++row) scan.scan_row(row);
      if (counter != nullptr) counter->add({.comparisons = scan.comparisons()});
      return scan.spans();
    });
  };
  return stages;
}

render::FrameStages make_cached_order(std::span<const double> values, Counter* counter) {
  const auto pairs = std::make_shared<PairOrders>(static_cast<std::size_t>(values[0]));
  const bool keeps_pairs = values[1] != 0;
  return make_stack_stages(
      [=](const render::FrameContext& context, const render::EdgeTable& table,
          std::span<const render::ScreenPlane> depths) {
        const world::Level* const level = context.scene.level;
        if (level != nullptr) pairs->use_level(*level, keeps_pairs);
        if (counter != nullptr) counter->add({.bytes = pairs->size_bytes()});
        return CachedOrder(DepthOrder(depths, kCachedRule), level, table.surfaces, *pairs);
      },
      counter);
}

}  // namespace temblor::lab
