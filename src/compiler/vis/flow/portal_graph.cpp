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

// One direction of an opening, before the portals are sorted.
struct Way {
  DirectedPortal portal;  // `reverse` is an index of this list; the corners are in `corners`
  Facing facing;
  std::vector<math::Vec3d> corners;
};

// First from behind the plane to the front. The other direction has the corners reversed, so that in both
// cases they are clockwise seen from the side that the portal leads to.
void add_both_directions(std::span<const math::Vec3d> corners, const Portal& portal,
                         std::vector<Way>& io_ways) {
  Way way;
  way.corners.assign(corners.begin(), corners.end());
  way.facing.beyond = {portal.normal, portal.distance};
  way.facing.center =
      std::accumulate(corners.begin(), corners.end(), math::Vec3d(0.0)) / static_cast<double>(corners.size());
  for (const math::Vec3d& corner : corners)
    way.facing.radius = std::max(way.facing.radius, glm::length(corner - way.facing.center));
  way.portal.to = portal.clusters[0];
  way.portal.from = portal.clusters[1];
  const auto number = static_cast<std::uint32_t>(io_ways.size());
  way.portal.reverse = number + 1;
  io_ways.push_back(way);
  std::ranges::reverse(way.corners);
  way.facing.beyond = way.facing.beyond.flipped();
  std::swap(way.portal.from, way.portal.to);
  way.portal.reverse = number;
  io_ways.push_back(std::move(way));
}

// Adds a portal with too many corners as a fan of convex pieces around its first corner.
void add_in_pieces(const Portal& portal, std::vector<Way>& io_ways) {
  const std::vector<math::Vec3d>& whole = portal.winding_world;
  std::vector<math::Vec3d> piece;
  for (std::size_t first = 1; first + 1 < whole.size(); first += kMaxPortalCorners - 2) {
    piece.assign(1, whole[0]);
    const std::size_t end = std::min(first + kMaxPortalCorners - 1, whole.size());
    for (std::size_t i = first; i < end; ++i) piece.push_back(whole[i]);
    add_both_directions(piece, portal, io_ways);
  }
}

// Sorts the portals by the cluster that they leave (a counting sort).
void add_sorted(std::span<const Way> ways, PortalGraph& io_graph) {
  io_graph.first_exit.assign(io_graph.cluster_count + 1, 0);
  for (const Way& way : ways) ++io_graph.first_exit[way.portal.from + 1];
  std::partial_sum(io_graph.first_exit.begin(), io_graph.first_exit.end(), io_graph.first_exit.begin());
  std::vector<std::uint32_t> next(io_graph.first_exit.begin(), io_graph.first_exit.end() - 1);
  std::vector<std::uint32_t> number_of_way, way_of_number(ways.size());
  for (std::uint32_t i = 0; i < ways.size(); ++i) {
    number_of_way.push_back(next[ways[i].portal.from]++);
    way_of_number[number_of_way.back()] = i;
  }
  for (const std::uint32_t i : way_of_number) {
    DirectedPortal portal = ways[i].portal;
    portal.reverse = number_of_way[portal.reverse];
    portal.first_corner = static_cast<std::uint32_t>(io_graph.corners.size());
    io_graph.corners.insert(io_graph.corners.end(), ways[i].corners.begin(), ways[i].corners.end());
    portal.end_corner = static_cast<std::uint32_t>(io_graph.corners.size());
    io_graph.portals.push_back(portal);
    io_graph.facings.push_back(ways[i].facing);
  }
}

// Bounds the portals of each cluster.
void measure_boxes(PortalGraph& io_graph) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  std::vector<math::Vec3d> mins(io_graph.cluster_count, math::Vec3d(kFar));
  std::vector<math::Vec3d> maxs(io_graph.cluster_count, math::Vec3d(-kFar));
  for (const DirectedPortal& portal : io_graph.portals) {
    for (const math::Vec3d& corner : io_graph.find_corners(portal)) {
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
  std::vector<Way> ways;
  for (const Portal& portal : merge_portals(set.portals)) {
    CHECK(portal.clusters[0] < set.cluster_count && portal.clusters[1] < set.cluster_count);
    CHECK(portal.winding_world.size() >= 3);
    if (portal.winding_world.size() <= kMaxPortalCorners)
      add_both_directions(portal.winding_world, portal, ways);
    else
      add_in_pieces(portal, ways);
  }
  add_sorted(ways, graph);
  measure_boxes(graph);
  return graph;
}

}  // namespace temblor::compiler::vis
