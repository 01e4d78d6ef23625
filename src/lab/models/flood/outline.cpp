#include "lab/models/flood/outline.h"

#include <algorithm>
#include <tuple>

namespace temblor::lab {

namespace {

bool is_front(const render::TriangleJob& job, const std::uint32_t* corner) {
  const render::ScreenVertex &a = job.vertices[corner[0]], &b = job.vertices[corner[1]],
                             &c = job.vertices[corner[2]];
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
             (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y) >
         0;
}

}  // namespace

MeshEdges::MeshEdges(std::span<const render::MeshTriangle> triangles)
    : triangles_(triangles.begin(), triangles.end()) {
  std::vector<Edge> sides;
  for (std::uint32_t i = 0; i < triangles.size(); ++i)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [from, to] = std::minmax(triangles[i][corner], triangles[i][(corner + 1) % 3]);
      sides.push_back({{from, to}, i, kNoTriangle});
    }
  std::ranges::sort(sides, {},
                    [](const Edge& side) { return std::tuple(side.ends.from, side.ends.to, side.triangle); });
  for (const Edge& side : sides) {
    const bool is_second = !edges_.empty() && edges_.back().ends.from == side.ends.from &&
                           edges_.back().ends.to == side.ends.to &&
                           edges_.back().other_triangle == kNoTriangle;
    if (is_second)
      edges_.back().other_triangle = side.triangle;
    else
      edges_.push_back(side);
  }
}

bool MeshEdges::match(std::span<const render::MeshTriangle> triangles) const {
  return std::ranges::equal(triangles_, triangles);
}

Outline find_outline(const render::TriangleJob& job, const MeshEdges& edges, base::Arena& arena) {
  const std::span<std::uint8_t> is_seen = arena.allocate_filled<std::uint8_t>(job.vertex_count, 0);
  const std::span<std::uint8_t> is_shown = arena.allocate<std::uint8_t>(job.triangle_count);
  for (std::size_t i = 0; i < job.triangle_count; ++i) {
    const std::uint32_t* const corner = job.triangles + 3 * i;
    is_shown[i] = is_front(job, corner) ? 1 : 0;
    for (std::size_t side = 0; side < 3; ++side) is_seen[corner[side]] |= is_shown[i];
  }
  base::ArenaVector<OutlineEdge> outline(arena, edges.all().size() + 1);
  for (const MeshEdges::Edge& edge : edges.all()) {
    const bool is_other_shown =
        edge.other_triangle != MeshEdges::kNoTriangle && is_shown[edge.other_triangle] != 0;
    if ((is_shown[edge.triangle] != 0) != is_other_shown) outline.push_back(edge.ends);
  }
  base::ArenaVector<std::uint32_t> vertices(arena, job.vertex_count + 1);
  for (std::uint32_t i = 0; i < job.vertex_count; ++i)
    if (is_seen[i] != 0) vertices.push_back(i);
  return {outline.view(), vertices.view()};
}

}  // namespace temblor::lab
