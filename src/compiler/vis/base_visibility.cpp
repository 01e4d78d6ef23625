#include "compiler/vis/base_visibility.h"

#include <algorithm>

namespace temblor::compiler::vis {

namespace {

// Whether some of the portal's winding lies in the half-space.
bool reaches_into(const DirectedPortal& portal, const HalfSpace& space) {
  const double centre_above = space.above(portal.centre);
  if (centre_above > kEpsilon) return true;
  if (centre_above < -portal.radius) return false;
  return std::ranges::any_of(portal.winding.corners(),
                             [&](const math::Vec3d& corner) { return space.above(corner) > kEpsilon; });
}

void flood(const PortalGraph& graph, std::size_t start, BitMatrix& io_matrix,
           std::vector<std::uint32_t>& scratch_clusters) {
  const DirectedPortal& source = graph.portals[start];
  io_matrix.set(start, source.to);
  scratch_clusters.assign(1, source.to);
  while (!scratch_clusters.empty()) {
    const std::uint32_t cluster = scratch_clusters.back();
    scratch_clusters.pop_back();
    for (const std::uint32_t index : graph.out_of(cluster)) {
      const DirectedPortal& portal = graph.portals[index];
      if (io_matrix.at(start, portal.to)) continue;
      if (!reaches_into(portal, source.beyond) || !reaches_into(source, portal.beyond.flipped())) continue;
      io_matrix.set(start, portal.to);
      scratch_clusters.push_back(portal.to);
    }
  }
}

}  // namespace

BitMatrix find_base_visibility(const PortalGraph& graph, base::Jobs& jobs) {
  BitMatrix matrix(graph.portals.size(), graph.cluster_count);
  constexpr std::size_t kBatch = 64;
  jobs.parallel_for((graph.portals.size() + kBatch - 1) / kBatch, [&](std::size_t batch) {
    std::vector<std::uint32_t> clusters;
    const std::size_t end = std::min((batch + 1) * kBatch, graph.portals.size());
    for (std::size_t i = batch * kBatch; i < end; ++i) flood(graph, i, matrix, clusters);
  });
  return matrix;
}

}  // namespace temblor::compiler::vis
