#include "compiler/vis/flow/portal_graph.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "base/check.h"
#include "compiler/vis/flow/merge_portals.h"

namespace temblor::compiler::vis {

namespace {

// Leaves room in a Winding for the corners that cutting adds.
constexpr std::size_t kMaxPortalCorners = 16;

// First from behind the plane to the front. The other direction has the corners reversed, so that in both
// cases they are clockwise seen from the side that the portal leads to.
void add_both_directions(std::span<const math::Vec3d> corners, const Portal& portal, PortalGraph& io_graph) {
  DirectedPortal directed;
  directed.winding.count = corners.size();
  std::ranges::copy(corners, directed.winding.points.begin());
  directed.beyond = {portal.normal, portal.distance};
  Facing facing;
  facing.beyond = directed.beyond;
  facing.center =
      std::accumulate(corners.begin(), corners.end(), math::Vec3d(0.0)) / static_cast<double>(corners.size());
  for (const math::Vec3d& corner : corners)
    facing.radius = std::max(facing.radius, glm::length(corner - facing.center));
  directed.to = portal.clusters[0];
  directed.from = portal.clusters[1];
  io_graph.portals.push_back(directed);
  io_graph.facings.push_back(facing);
  std::reverse(directed.winding.points.begin(),
               directed.winding.points.begin() + static_cast<std::ptrdiff_t>(corners.size()));
  directed.beyond = directed.beyond.flipped();
  std::swap(directed.from, directed.to);
  facing.beyond = directed.beyond;
  io_graph.portals.push_back(directed);
  io_graph.facings.push_back(facing);
}

// Adds a portal with too many corners as a fan of convex pieces around its first corner.
void add_in_pieces(const Portal& portal, PortalGraph& io_graph) {
  const std::vector<math::Vec3d>& whole = portal.winding_world;
  std::vector<math::Vec3d> piece;
  for (std::size_t first = 1; first + 1 < whole.size(); first += kMaxPortalCorners - 2) {
    piece.assign(1, whole[0]);
    const std::size_t end = std::min(first + kMaxPortalCorners - 1, whole.size());
    for (std::size_t i = first; i < end; ++i) piece.push_back(whole[i]);
    add_both_directions(piece, portal, io_graph);
  }
}

// Sorts the portals by the cluster that they leave (a counting sort).
void list_by_cluster(PortalGraph& io_graph) {
  io_graph.first_exit.assign(io_graph.cluster_count + 1, 0);
  for (const DirectedPortal& portal : io_graph.portals) ++io_graph.first_exit[portal.from + 1];
  std::partial_sum(io_graph.first_exit.begin(), io_graph.first_exit.end(), io_graph.first_exit.begin());
  io_graph.exits.resize(io_graph.portals.size());
  std::vector<std::uint32_t> next(io_graph.first_exit.begin(), io_graph.first_exit.end() - 1);
  for (std::uint32_t i = 0; i < io_graph.portals.size(); ++i)
    io_graph.exits[next[io_graph.portals[i].from]++] = {i, io_graph.portals[i].to};
}

// Bounds the portals of each cluster.
void measure_boxes(PortalGraph& io_graph) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<math::Vec3d> mins(io_graph.cluster_count, math::Vec3d(kFar));
  std::vector<math::Vec3d> maxs(io_graph.cluster_count, math::Vec3d(-kFar));
  for (const DirectedPortal& portal : io_graph.portals) {
    for (const math::Vec3d& corner : portal.winding.corners()) {
      mins[portal.to] = glm::min(mins[portal.to], corner);
      maxs[portal.to] = glm::max(maxs[portal.to], corner);
    }
  }
  io_graph.boxes.resize(io_graph.cluster_count);
  for (std::size_t i = 0; i < io_graph.cluster_count; ++i)
    if (mins[i].x <= maxs[i].x) io_graph.boxes[i] = {(mins[i] + maxs[i]) * 0.5, (maxs[i] - mins[i]) * 0.5};
}

}  // namespace

PortalGraph make_portal_graph(const PortalSet& set) {
  PortalGraph graph;
  graph.cluster_count = set.cluster_count;
  for (const Portal& portal : merge_portals(set.portals)) {
    CHECK(portal.clusters[0] < set.cluster_count && portal.clusters[1] < set.cluster_count);
    CHECK(portal.winding_world.size() >= 3);
    if (portal.winding_world.size() <= kMaxPortalCorners)
      add_both_directions(portal.winding_world, portal, graph);
    else
      add_in_pieces(portal, graph);
  }
  list_by_cluster(graph);
  measure_boxes(graph);
  return graph;
}

}  // namespace temblor::compiler::vis
