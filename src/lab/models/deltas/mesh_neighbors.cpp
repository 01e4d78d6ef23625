#include "lab/models/deltas/mesh_neighbors.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace temblor::lab {

namespace {

const void* find_poses(const render::AliasModel& model) {
  return model.is_wide() ? static_cast<const void*>(model.wide_poses.data()) : model.poses.data();
}
std::size_t count_pose_bytes(const render::AliasModel& model) {
  return model.poses.size() + model.wide_poses.size() * sizeof(std::uint16_t);
}

// By vertex: the first vertex with the same place in all poses.
template <typename Element>
std::vector<std::uint32_t> join_vertices(std::span<const Element> poses, std::size_t row, std::size_t count) {
  const auto compare = [&](std::uint32_t a, std::uint32_t b) {
    for (std::size_t at = 0; at < poses.size(); at += row) {
      const bool is_normals = at / row % 4 == 3;
      if (!is_normals && poses[at + a] != poses[at + b]) return poses[at + a] < poses[at + b] ? -1 : 1;
    }
    return 0;
  };
  std::vector<std::uint32_t> order(count), joined(count);
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    const int sign = compare(a, b);
    return sign != 0 ? sign < 0 : a < b;
  });
  for (std::size_t i = 0; i < count; ++i)
    joined[order[i]] = i > 0 && compare(order[i - 1], order[i]) == 0 ? joined[order[i - 1]] : order[i];
  return joined;
}

bool is_front(const render::TriangleJob& job, std::uint32_t triangle) {
  const std::uint32_t* const corner = job.triangles + 3 * std::size_t{triangle};
  const render::ScreenVertex &a = job.vertices[corner[0]], &b = job.vertices[corner[1]],
                             &c = job.vertices[corner[2]];
  return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
             (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y) >
         0;
}

}  // namespace

MeshNeighbors::MeshNeighbors(const render::AliasModel& model)
    : triangles_(model.triangles),
      poses_(find_poses(model)),
      pose_bytes_(count_pose_bytes(model)),
      sides_(model.triangles.size()) {
  const std::vector<std::uint32_t> joined =
      model.is_wide()
          ? join_vertices<std::uint16_t>(model.wide_poses, model.vertices_per_row, model.vertex_count)
          : join_vertices<std::uint8_t>(model.poses, model.vertices_per_row, model.vertex_count);
  struct HalfEdge {
    std::uint32_t from, to, triangle, side;
  };
  std::vector<HalfEdge> halves;
  for (std::uint32_t i = 0; i < triangles_.size(); ++i)
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto [from, to] = std::minmax(joined[triangles_[i][side]], joined[triangles_[i][(side + 1) % 3]]);
      halves.push_back({from, to, i, side});
    }
  std::ranges::sort(halves, {}, [](const HalfEdge& half) {
    return std::tuple(half.from, half.to, half.triangle, half.side);
  });
  for (std::size_t i = 0; i < halves.size(); ++edge_count_) {
    const auto is_same = [&](std::size_t other) {
      return other < halves.size() && halves[other].from == halves[i].from &&
             halves[other].to == halves[i].to;
    };
    const bool has_neighbor = is_same(i + 1);
    const auto set = [&](std::size_t half, std::uint32_t neighbor) {
      sides_[halves[half].triangle][halves[half].side] = {static_cast<std::uint32_t>(edge_count_), neighbor};
    };
    set(i, has_neighbor ? halves[i + 1].triangle : kNone);
    if (has_neighbor) set(i + 1, halves[i].triangle);
    i += has_neighbor ? 2 : 1;
  }
}

bool MeshNeighbors::match(const render::AliasModel& model) const {
  return poses_ == find_poses(model) && pose_bytes_ == count_pose_bytes(model) &&
         std::ranges::equal(triangles_, model.triangles);
}

VisibleWalk walk_visible_side(const render::TriangleJob& job, const MeshNeighbors& neighbors,
                              bool has_many_seeds, base::Arena& arena) {
  // Triangles that are at the back, or are already in the walk.
  const std::span<std::uint8_t> is_done = arena.allocate<std::uint8_t>(job.triangle_count);
  std::uint32_t nearest = MeshNeighbors::kNone;
  float nearest_depth = 0;
  for (std::uint32_t i = 0; i < job.triangle_count; ++i) {
    is_done[i] = is_front(job, i) ? 0 : 1;
    const float depth = job.vertices[job.triangles[3 * std::size_t{i}]].depth;
    if (is_done[i] != 0 || (nearest != MeshNeighbors::kNone && depth <= nearest_depth)) continue;
    nearest = i;
    nearest_depth = depth;
  }
  if (nearest == MeshNeighbors::kNone) return {};
  const std::span<std::uint32_t> walk = arena.allocate<std::uint32_t>(job.triangle_count);
  std::size_t next = 0, end = 0, seeds = 0;
  const auto begin_at = [&](std::uint32_t seed) {
    ++seeds;
    is_done[seed] = 1;
    walk[end++] = seed;
    for (; next < end; ++next)
      for (const MeshNeighbors::Side& side : neighbors.sides(walk[next])) {
        if (side.neighbor == MeshNeighbors::kNone || is_done[side.neighbor] != 0) continue;
        is_done[side.neighbor] = 1;
        walk[end++] = side.neighbor;
      }
  };
  begin_at(nearest);
  if (has_many_seeds)
    for (std::uint32_t i = 0; i < job.triangle_count; ++i)
      if (is_done[i] == 0) begin_at(i);
  return {walk.first(end), seeds};
}

}  // namespace temblor::lab
