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
  Winding winding;
  HalfSpace beyond;                // the side that it leads to
  std::uint32_t from = 0, to = 0;  // clusters
};

// The data for most tests of a portal, in one cache line: the portals of a large hall do not fit into the
// cache, and each is tested against most others.
struct Facing {
  HalfSpace beyond;
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

// A portal, and the cluster that it leads to.
struct Exit {
  std::uint32_t portal = 0, to = 0;
};

// A box around all portals of a cluster: anyone who sees into the cluster sees some of the box.
struct ClusterBox {
  math::Vec3d center{0.0}, half_size{0.0};

  // How far the deepest corner is inside the half-space, in units.
  double highest(const HalfSpace& space) const {
    return space.above(center) + glm::dot(glm::abs(space.normal), half_size);
  }
};

// Clusters and the portals between them.
struct PortalGraph {
  std::size_t cluster_count = 0;
  std::vector<DirectedPortal> portals;    // 2 * i and 2 * i + 1 are the two directions of one opening
  std::vector<Facing> facings;            // by portal
  std::vector<ClusterBox> boxes;          // by cluster
  std::vector<std::uint32_t> first_exit;  // by cluster, plus one: where its part of `exits` begins
  std::vector<Exit> exits;                // by the cluster that they leave

  std::span<const Exit> exits_from(std::size_t cluster) const {
    return std::span(exits).subspan(first_exit[cluster], first_exit[cluster + 1] - first_exit[cluster]);
  }
};

// An opening with so many corners that cutting it would overflow a Winding becomes several. Every cluster of
// the set is below cluster_count, and every winding has at least three corners (CHECKed).
PortalGraph make_portal_graph(const PortalSet& set);

}  // namespace temblor::compiler::vis
