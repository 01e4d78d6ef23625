// Method: a flood fill from each portal, which enters a portal only if it and the first one can face each
// other. It ignores everything in between, so it never misses anything visible.
#include "compiler/vis/flow/base_visibility.h"

#include <algorithm>

namespace temblor::compiler::vis {

namespace {

// The data for most tests of a portal, in one cache line: the portals of a large hall do not fit into the
// cache, and each is tested against most others.
struct Facing {
  HalfSpace beyond;
  math::Vec3d center;
  double radius;
};

// A portal, and the cluster that it leads to.
struct Exit {
  std::uint32_t portal, to;
};

// The graph with all that flood() reads packed side by side.
struct FlatGraph {
  const PortalGraph& graph;
  std::vector<Facing> facings;  // by portal
  std::vector<Exit> exits;      // parallel to graph.out

  std::span<const Exit> portals_from(std::size_t cluster) const {
    return std::span(exits).subspan(graph.first_out[cluster],
                                    graph.first_out[cluster + 1] - graph.first_out[cluster]);
  }
};

FlatGraph flatten(const PortalGraph& graph) {
  FlatGraph flat{graph, {}, {}};
  for (const DirectedPortal& portal : graph.portals)
    flat.facings.push_back({portal.beyond, portal.center, portal.radius});
  for (const std::uint32_t portal : graph.out) flat.exits.push_back({portal, graph.portals[portal].to});
  return flat;
}

// Whether some of the portal's winding is inside the half-space.
bool reaches_into(const FlatGraph& flat, std::uint32_t portal, const HalfSpace& space) {
  const Facing& facing = flat.facings[portal];
  const double center_above = space.above(facing.center);
  if (center_above > kEpsilon) return true;
  if (center_above < -facing.radius) return false;
  return std::ranges::any_of(flat.graph.portals[portal].winding.corners(),
                             [&](const math::Vec3d& corner) { return space.above(corner) > kEpsilon; });
}

// Clusters are marked when they are found, so each is visited once, whichever portal leads there first.
void flood(const FlatGraph& flat, std::uint32_t start, BitMatrix& io_matrix,
           std::vector<std::uint32_t>& scratch_clusters) {
  const HalfSpace& beyond = flat.facings[start].beyond;
  const auto seen = io_matrix.row(start);
  const std::uint32_t first = flat.graph.portals[start].to;
  set_bit(seen, first);
  scratch_clusters.assign(1, first);
  while (!scratch_clusters.empty()) {
    const std::uint32_t cluster = scratch_clusters.back();
    scratch_clusters.pop_back();
    for (const Exit& exit : flat.portals_from(cluster)) {
      if (has_bit(seen, exit.to)) continue;
      if (!reaches_into(flat, exit.portal, beyond) ||
          !reaches_into(flat, start, flat.facings[exit.portal].beyond.flipped()))
        continue;
      set_bit(seen, exit.to);
      scratch_clusters.push_back(exit.to);
    }
  }
}

}  // namespace

BitMatrix find_base_visibility(const PortalGraph& graph, base::Jobs& jobs) {
  BitMatrix matrix(graph.portals.size(), graph.cluster_count);
  const FlatGraph flat = flatten(graph);
  constexpr std::size_t kBatch = 64;
  jobs.parallel_for((graph.portals.size() + kBatch - 1) / kBatch, [&](std::size_t batch) {
    std::vector<std::uint32_t> clusters;
    const std::size_t end = std::min((batch + 1) * kBatch, graph.portals.size());
    for (std::size_t i = batch * kBatch; i < end; ++i)
      flood(flat, static_cast<std::uint32_t>(i), matrix, clusters);
  });
  return matrix;
}

}  // namespace temblor::compiler::vis
