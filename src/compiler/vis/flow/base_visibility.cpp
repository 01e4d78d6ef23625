#include "compiler/vis/flow/base_visibility.h"

#include <algorithm>

namespace temblor::compiler::vis {

namespace {

// What decides most questions about a portal, in one line of cache: the portals of a wide hall do not fit
// into it, and each asks about most others.
struct Facing {
  HalfSpace beyond;
  math::Vec3d center;
  double radius;
};

struct Way {
  std::uint32_t portal, to;
};

struct FlatGraph {
  const PortalGraph& graph;
  std::vector<Facing> facings;  // by portal
  std::vector<Way> ways;        // as graph.out

  std::span<const Way> out_of(std::size_t cluster) const {
    return std::span(ways).subspan(graph.first_out[cluster],
                                   graph.first_out[cluster + 1] - graph.first_out[cluster]);
  }
};

FlatGraph flatten(const PortalGraph& graph) {
  FlatGraph flat{graph, {}, {}};
  for (const DirectedPortal& portal : graph.portals)
    flat.facings.push_back({portal.beyond, portal.center, portal.radius});
  for (const std::uint32_t portal : graph.out) flat.ways.push_back({portal, graph.portals[portal].to});
  return flat;
}

// Whether some of the portal's winding lies in the half-space.
bool reaches_into(const FlatGraph& flat, std::uint32_t portal, const HalfSpace& space) {
  const Facing& facing = flat.facings[portal];
  const double center_above = space.above(facing.center);
  if (center_above > kEpsilon) return true;
  if (center_above < -facing.radius) return false;
  return std::ranges::any_of(flat.graph.portals[portal].winding.corners(),
                             [&](const math::Vec3d& corner) { return space.above(corner) > kEpsilon; });
}

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
    for (const Way& way : flat.out_of(cluster)) {
      if (has_bit(seen, way.to)) continue;
      if (!reaches_into(flat, way.portal, beyond) ||
          !reaches_into(flat, start, flat.facings[way.portal].beyond.flipped()))
        continue;
      set_bit(seen, way.to);
      scratch_clusters.push_back(way.to);
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
