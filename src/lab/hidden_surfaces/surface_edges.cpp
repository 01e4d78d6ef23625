#include "lab/hidden_surfaces/surface_edges.h"

#include <algorithm>

#include "render/edges/edge_crossing.h"

namespace temblor::lab {

namespace {

// No edge on the right means that the surface extends beyond the screen: the engine drops such edges.
constexpr std::int32_t kNoEnd = -1;

}  // namespace

SurfaceEdges group_edges(const render::FrameContext& context, const render::EdgeTable& table) {
  base::Arena& arena = context.arena();
  const std::size_t surfaces = table.first_deferred();
  const std::span<std::uint32_t> begin = arena.allocate_filled<std::uint32_t>(surfaces + 1, 0);
  const std::span<render::RowRange> rows =
      arena.allocate_filled<render::RowRange>(surfaces, {std::numeric_limits<int>::max(), 0});
  const auto for_each_side = [&](auto&& add) {
    for (std::uint32_t number = 0; number < table.edges.size(); ++number) {
      const render::Edge& edge = table.edges[number];
      if (edge.leading != render::kBackground) add(base::to_size(edge.leading), EdgeSide{number, true});
      if (edge.trailing != render::kBackground) add(base::to_size(edge.trailing), EdgeSide{number, false});
    }
  };
  for_each_side([&](std::size_t surface, EdgeSide side) {
    ++begin[surface];
    const render::Edge& edge = table.edges[side.edge];
    rows[surface].first = std::min(rows[surface].first, int{edge.first_row});
    rows[surface].end = std::max(rows[surface].end, edge.last_row + 1);
  });
  // From counts to positions: of the last side first, because adding one moves the position down.
  std::uint32_t before = 0;
  for (std::uint32_t& count : begin) before = count += before;
  const std::span<EdgeSide> sides = arena.allocate<EdgeSide>(before);
  for_each_side([&](std::size_t surface, EdgeSide side) { sides[--begin[surface]] = side; });
  return {begin, sides, rows};
}

SurfaceScan::SurfaceScan(const render::EdgeTable& table, const SurfaceEdges& edges, render::RowRange rows,
                         int width, base::Arena& arena)
    : table_(table),
      edges_(edges),
      rows_(rows),
      width_(width),
      spans_(arena.allocate<RowSpan>(static_cast<std::size_t>(rows.end - rows.first))) {}

render::RowRange SurfaceScan::scan(std::size_t surface) {
  const render::RowRange all = edges_.rows[surface];
  const render::RowRange rows{std::max(all.first, rows_.first), std::min(all.end, rows_.end)};
  if (rows.first >= rows.end) return {rows_.first, rows_.first};
  RowSpan* const spans = spans_.data() - rows_.first;
  std::fill(spans + rows.first, spans + rows.end, RowSpan{width_, kNoEnd});
  const double width = width_;
  for (const EdgeSide side : edges_.surface_sides(surface)) {
    const render::Edge& edge = table_.edges[side.edge];
    const int end = std::min(edge.last_row + 1, rows.end);
    for (int row = std::max(int{edge.first_row}, rows.first); row < end; ++row) {
      const double x = std::min(render::crossing(edge.x_first, edge.step, row - edge.first_row), width);
      const int pixel = render::first_pixel(x);
      if (side.is_leading)
        spans[row].first = std::min(spans[row].first, pixel);
      else
        spans[row].end = std::max(spans[row].end, pixel);
    }
  }
  for (int row = rows.first; row < rows.end; ++row)
    if (spans[row].end == kNoEnd) spans[row].end = width_;
  return rows;
}

}  // namespace temblor::lab
