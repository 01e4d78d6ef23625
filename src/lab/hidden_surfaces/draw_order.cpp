#include "lab/hidden_surfaces/draw_order.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace temblor::lab {

namespace {

// A fragment of a brush model on the screen.
struct Fragment {
  std::uint32_t surface;
  render::ScreenPlane depth;
  std::span<const math::Vec2d> corners;
  math::Vec2d mins, maxs;
  double center_depth;
};

// The ends of a surface's edges, and of its right side where that is beyond the screen and has no edges.
std::span<const math::Vec2d> list_corners(const render::EdgeTable& table, const SurfaceEdges& edges,
                                          std::uint32_t surface, int width, base::Arena& arena) {
  const std::span<const EdgeSide> sides = edges.surface_sides(surface);
  const render::RowRange rows = edges.rows[surface];
  base::ArenaVector<math::Vec2d> corners(arena, 2 * sides.size() + 4);
  render::RowRange bounded{rows.end, rows.first};  // rows with an edge on the right
  for (const EdgeSide side : sides) {
    const render::Edge& edge = table.edges[side.edge];
    corners.push_back({edge.x_first, edge.first_row});
    corners.push_back({edge.x_first + edge.step * (edge.last_row - edge.first_row), edge.last_row});
    if (side.is_leading) continue;
    bounded.first = std::min(bounded.first, int{edge.first_row});
    bounded.end = std::max(bounded.end, edge.last_row + 1);
  }
  const auto add_right_side = [&](int first, int end) {
    if (first >= end) return;
    corners.push_back({width, first});
    corners.push_back({width, end - 1});
  };
  add_right_side(rows.first, bounded.first);
  add_right_side(std::max(bounded.end, bounded.first), rows.end);
  return corners.view();
}

Fragment measure_fragment(const render::EdgeTable& table, std::uint32_t surface,
                          std::span<const math::Vec2d> corners) {
  Fragment fragment{surface,
                    table.fragments[table.surfaces[surface].fragment].depth,
                    corners,
                    math::Vec2d(1e30),
                    math::Vec2d(-1e30),
                    0};
  math::Vec2d sum(0.0);
  for (const math::Vec2d& corner : corners) {
    fragment.mins = glm::min(fragment.mins, corner);
    fragment.maxs = glm::max(fragment.maxs, corner);
    sum += corner;
  }
  const math::Vec2d center = sum / static_cast<double>(std::max<std::size_t>(corners.size(), 1));
  fragment.center_depth = fragment.depth.at(center.x, center.y);
  return fragment;
}

// Whether `depth` is nowhere greater (nearer) than `other` at the corners.
bool all_behind(std::span<const math::Vec2d> corners, const render::ScreenPlane& depth,
                const render::ScreenPlane& other) {
  constexpr double kTouching = 1e-6;
  return std::ranges::all_of(corners, [&](const math::Vec2d& at) {
    const double here = depth.at(at.x, at.y);
    return here <= other.at(at.x, at.y) + kTouching * std::abs(here);
  });
}

// The tests of Newell, Newell, and Sancha (1972): whether drawing `a` before `b` cannot be wrong.
bool may_come_first(const Fragment& a, const Fragment& b) {
  if (a.maxs.x < b.mins.x || b.maxs.x < a.mins.x || a.maxs.y < b.mins.y || b.maxs.y < a.mins.y) return true;
  if (all_behind(a.corners, a.depth, b.depth)) return true;
  const render::ScreenPlane nearer{-b.depth.at_origin, -b.depth.dx, -b.depth.dy};
  const render::ScreenPlane farther{-a.depth.at_origin, -a.depth.dx, -a.depth.dy};
  return all_behind(b.corners, nearer, farther);
}

// Returns the numbers of fragments with equal sort keys from back to front. Each time, the farthest one that
// may come before all others is next; if there is none, because they form a circle, the farthest one. Takes
// time with the square of their number.
std::span<const std::uint32_t> order_fragments(std::span<const Fragment> fragments, base::Arena& arena) {
  const std::size_t count = fragments.size();
  const std::span<std::uint32_t> farthest_first = arena.allocate<std::uint32_t>(count);
  std::iota(farthest_first.begin(), farthest_first.end(), 0u);
  std::ranges::sort(farthest_first, {}, [&](std::uint32_t i) { return fragments[i].center_depth; });
  // How many of the fragments that are left each one must not come before.
  const std::span<std::uint32_t> blocked = arena.allocate_filled<std::uint32_t>(count, 0);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t other = 0; other < count; ++other)
      blocked[i] += other != i && !may_come_first(fragments[i], fragments[other]);
  const std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(count);
  for (std::size_t done = 0; done < count; ++done) {
    const std::span<std::uint32_t> left = farthest_first.first(count - done);
    auto next = std::ranges::find_if(left, [&](std::uint32_t i) { return blocked[i] == 0; });
    if (next == left.end()) next = left.begin();
    order[done] = *next;
    std::rotate(next, next + 1, left.end());
    for (const std::uint32_t i : left.first(left.size() - 1))
      blocked[i] -= !may_come_first(fragments[i], fragments[order[done]]);
  }
  return order;
}

render::Band order_band(const render::Band& band, std::span<const std::uint32_t> rank, base::Arena& arena) {
  const std::size_t count = band.draws.size();
  const std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(count);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, {}, [&](std::uint32_t position) { return rank[band.draws[position]]; });
  const std::span<render::Span> spans = arena.allocate<render::Span>(band.spans.size());
  const std::span<std::uint32_t> draws = arena.allocate<std::uint32_t>(count);
  const std::span<std::uint32_t> span_begin = arena.allocate<std::uint32_t>(count + 1);
  const std::span<render::PixelSum> sums = arena.allocate<render::PixelSum>(count);
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::span<const render::Span> own = band.spans_at(order[i]);
    std::ranges::copy(own, spans.begin() + before);
    draws[i] = band.draws[order[i]];
    sums[i] = band.sums[order[i]];
    span_begin[i] = before;
    before += static_cast<std::uint32_t>(own.size());
  }
  span_begin[count] = before;
  return {band.first_row, band.row_count, spans, draws, span_begin, sums};
}

}  // namespace

std::span<const std::uint32_t> order_back_to_front(const render::FrameContext& context,
                                                   const render::EdgeTable& table, const SurfaceEdges& edges,
                                                   int width) {
  base::Arena& arena = context.arena();
  const std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(table.first_deferred());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t surface) { return table.surfaces[surface].key; };
  std::ranges::sort(
      order, [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) > key(b) : a < b; });
  // Only fragments of brush models share keys.
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin + 1;
    while (end < order.size() && key(order[end]) == key(order[begin])) ++end;
    if (end - begin > 1) {
      const std::span<Fragment> fragments = arena.allocate<Fragment>(end - begin);
      for (std::size_t i = begin; i < end; ++i)
        fragments[i - begin] =
            measure_fragment(table, order[i], list_corners(table, edges, order[i], width, arena));
      const std::span<const std::uint32_t> sorted = order_fragments(fragments, arena);
      for (std::size_t i = begin; i < end; ++i) order[i] = fragments[sorted[i - begin]].surface;
    }
    begin = end;
  }
  return order;
}

render::SpanTable order_draws(const render::FrameContext& context, const render::EdgeTable& table,
                              const render::SpanTable& spans, std::span<const std::uint32_t> surfaces) {
  base::Arena& arena = context.arena();
  const std::span<std::uint32_t> rank = arena.allocate<std::uint32_t>(table.draw_count);
  std::iota(rank.begin(), rank.end(), 0u);  // deferred draws keep their places after all others
  for (std::uint32_t i = 0, next = 0; i < surfaces.size(); ++i) {
    const render::ScreenSurface& surface = table.surfaces[surfaces[i]];
    for (std::uint32_t tile = 0; tile < std::uint32_t{surface.tiles.s} * surface.tiles.t; ++tile)
      rank[surface.first_draw + tile] = next++;
  }
  const std::span<render::Band> bands = arena.allocate<render::Band>(spans.bands.size());
  context.jobs.parallel_for(bands.size(), [&](std::size_t i) {
    bands[i] = order_band(spans.bands[i], rank, context.arenas.bands[i]);
  });
  return {bands};
}

}  // namespace temblor::lab
