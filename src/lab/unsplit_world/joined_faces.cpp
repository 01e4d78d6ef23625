#include "lab/unsplit_world/joined_faces.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace temblor::lab {

namespace {

// Equal for faces that can be one.
auto make_key(const world::Level& level, std::uint32_t number) {
  const world::Face& face = level.faces[number];
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  const std::array<float, 8> texture_axes = {axes.s_axis.x, axes.s_axis.y, axes.s_axis.z, axes.s_offset,
                                             axes.t_axis.x, axes.t_axis.y, axes.t_axis.z, axes.t_offset};
  return std::tuple(face.plane, face.back_side, face.texture, texture_axes);
}

// The order of edges by rows, without those that have no sides left.
render::EdgeTable leave_out_edges(const render::EdgeTable& table, std::span<const render::Edge> edges,
                                  base::Arena& arena) {
  const std::span<std::uint32_t> order = arena.allocate<std::uint32_t>(table.order.size());
  const std::span<std::uint32_t> row_begin = arena.allocate<std::uint32_t>(table.row_begin.size());
  std::uint32_t kept = 0;
  for (std::size_t row = 0; row + 1 < table.row_begin.size(); ++row) {
    row_begin[row] = kept;
    for (std::uint32_t i = table.row_begin[row]; i < table.row_begin[row + 1]; ++i) {
      const render::Edge& edge = edges[table.order[i]];
      if (edge.leading != edge.trailing) order[kept++] = table.order[i];
    }
  }
  row_begin.back() = kept;
  render::EdgeTable left = table;
  left.edges = edges;
  left.order = order.first(kept);
  left.row_begin = row_begin;
  return left;
}

}  // namespace

std::vector<world::FaceIndex> find_first_parts(const world::Level& level) {
  std::vector<std::uint32_t> numbers(level.faces.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::ranges::stable_sort(
      numbers, [&](std::uint32_t a, std::uint32_t b) { return make_key(level, a) < make_key(level, b); });
  std::vector<world::FaceIndex> first_parts(numbers.size());
  std::uint32_t first = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i == 0 || make_key(level, numbers[i]) != make_key(level, first)) first = numbers[i];
    first_parts[numbers[i]] = base::to_index<world::FaceIndex>(first);
  }
  return first_parts;
}

JoinedTable join_parts(const render::FrameContext& context, const render::EdgeTable& table,
                       std::span<const world::FaceIndex> first_parts) {
  base::Arena& arena = context.arena();
  const std::size_t count = table.first_deferred();
  const auto stands_for = arena.allocate<render::SurfaceIndex>(count);
  const auto part_counts = arena.allocate_filled<std::uint32_t>(count, 0);
  const auto surface_of_face = arena.allocate_filled(first_parts.size(), render::kBackground);
  for (std::uint32_t i = 0; i < count; ++i) {
    const render::ScreenSurface& surface = table.surfaces[i];
    render::SurfaceIndex joined{i};
    if (i > 0 && surface.instance == 0 && !first_parts.empty()) {
      render::SurfaceIndex& first = surface_of_face[base::to_size(first_parts[base::to_size(surface.face)])];
      if (first == render::kBackground) first = joined;
      joined = first;
    }
    stands_for[i] = joined;
    ++part_counts[base::to_size(joined)];
  }
  const std::span<render::Edge> edges = arena.allocate<render::Edge>(table.edges.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    edges[i] = table.edges[i];
    edges[i].leading = stands_for[base::to_size(edges[i].leading)];
    edges[i].trailing = stands_for[base::to_size(edges[i].trailing)];
  }
  const render::EdgeTable joined = leave_out_edges(table, edges, arena);
  return {joined, stands_for, part_counts, table.order.size() - joined.order.size()};
}

}  // namespace temblor::lab
