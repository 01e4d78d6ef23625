// Method: a flood fill from each portal, which enters a portal only if it and the first one can face each
// other. It ignores everything in between, so it never misses anything visible.
#include "compiler/vis/flow/base_visibility.h"

#include <algorithm>

namespace temblor::compiler::vis {

namespace {

// Whether some of the portal's winding is inside the half-space.
bool reaches_into(const PortalGraph& graph, std::uint32_t portal, const HalfSpace& space) {
  const Facing& facing = graph.facings[portal];
  const double center_above = space.above(facing.center);
  if (center_above > kEpsilon) return true;
  if (center_above < -facing.radius) return false;
  return std::ranges::any_of(graph.find_corners(portal),
                             [&](const math::Vec3d& corner) { return space.above(corner) > kEpsilon; });
}

// Clusters are marked when they are found, so each is visited once, whichever portal leads there first.
void flood(const PortalGraph& graph, std::uint32_t start, BitMatrix& io_matrix,
           std::vector<std::uint32_t>& scratch_clusters) {
  const HalfSpace& beyond = graph.facings[start].beyond;
  const auto seen = io_matrix.row(start);
  const std::uint32_t first = graph.portals[start].to;
  set_bit(seen, first);
  scratch_clusters.assign(1, first);
  while (!scratch_clusters.empty()) {
    const std::uint32_t cluster = scratch_clusters.back();
    scratch_clusters.pop_back();
    for (std::uint32_t exit = graph.first_exit[cluster]; exit < graph.first_exit[cluster + 1]; ++exit) {
      const std::uint32_t to = graph.portals[exit].to;
      if (has_bit(seen, to)) continue;
      if (!reaches_into(graph, exit, beyond) ||
          !reaches_into(graph, start, graph.facings[exit].beyond.flipped()))
        continue;
      set_bit(seen, to);
      scratch_clusters.push_back(to);
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
    for (std::size_t i = batch * kBatch; i < end; ++i)
      flood(graph, static_cast<std::uint32_t>(i), matrix, clusters);
  });
  return matrix;
}

}  // namespace temblor::compiler::vis
