#include "lab/hidden_surfaces/depth_edges.h"

#include <memory>

#include "lab/hidden_surfaces/depth_stack.h"
#include "lab/hidden_surfaces/intersecting_scan.h"
#include "lab/hidden_surfaces/pair_orders.h"
#include "lab/hidden_surfaces/stack_scan.h"
#include "lab/hidden_surfaces/surface_depths.h"
#include "render/edges/make_span_table.h"

namespace temblor::lab {

namespace {

using render::DrawSpan;

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
