// The portals as the search walks them: once for each direction, listed by the cluster that they leave.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "compiler/vis/flow/winding.h"
#include "compiler/vis/portals.h"

namespace temblor::compiler::vis {

// An opening, seen in one direction.
struct DirectedPortal {
  std::uint32_t from = 0, to = 0;                  // clusters
  std::uint32_t reverse = 0;                       // the portal of the other direction
  std::uint32_t first_corner = 0, end_corner = 0;  // of PortalGraph::corners
};

// The data for most tests of a portal, in one cache line: the portals of a large hall do not fit into the
// cache, and each is tested against most others.
struct Facing {
  HalfSpace beyond;         // the side that it leads to
  math::Vec3d center{0.0};  // of a sphere that contains the winding
  double radius = 0;
};

// The side on which a portal lies, by its sphere; kAcross if that does not tell.
enum class Side { kInside, kOutside, kAcross };
inline Side find_side(const Facing& portal, const HalfSpace& space) {
  const double above = space.above(portal.center);
  if (above >= portal.radius - kEpsilon) return Side::kInside;
  return above <= kEpsilon - portal.radius ? Side::kOutside : Side::kAcross;
}

// A box around all portals of a cluster: anyone who sees into the cluster sees some of the box.
struct ClusterBox {
  math::Vec3d center{0.0}, half_size{0.0};

  // How far the deepest corner is inside the half-space, in units.
  double highest(const HalfSpace& space) const {
    return space.above(center) + glm::dot(glm::abs(space.normal), half_size);
  }
};

// Clusters and the portals between them. Portals that leave one cluster are neighbors in all lists, since a
// search tries them together.
struct PortalGraph {
  std::size_t cluster_count = 0;
  std::vector<DirectedPortal> portals;  // sorted by the cluster that they leave
  std::vector<Facing> facings;          // by portal
  std::vector<math::Vec3d> corners;
  std::vector<ClusterBox> boxes;          // by cluster
  std::vector<std::uint32_t> first_exit;  // by cluster, plus one: where its part of `portals` begins

  // Clockwise seen from the side that the portal leads to.
  std::span<const math::Vec3d> find_corners(const DirectedPortal& portal) const {
    return std::span(corners).subspan(portal.first_corner, portal.end_corner - portal.first_corner);
  }
  std::span<const math::Vec3d> find_corners(std::uint32_t portal) const {
    return find_corners(portals[portal]);
  }
};

// An opening with so many corners that cutting it would overflow a Winding becomes several. Every cluster of
// the set is below cluster_count, and every winding has at least three corners (CHECKed).
PortalGraph make_portal_graph(const PortalSet& set);

}  // namespace temblor::compiler::vis
