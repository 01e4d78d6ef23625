// Portals as the flow walks them: each in both directions, known by the cluster that it leaves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <span>
#include <vector>

#include "compiler/vis/flow/winding.h"
#include "compiler/vis/portals.h"

namespace temblor::compiler::vis {

struct DirectedPortal {
  Winding winding;
  HalfSpace beyond;  // what it leads to lies in front
  math::Vec3d center{0.0};
  double radius = 0;               // of the sphere around the center that holds the winding
  std::uint32_t from = 0, to = 0;  // clusters
};

// Around all portals of a cluster: who sees into it sees some of this.
struct ClusterBox {
  math::Vec3d center{0.0}, half_size{0.0};

  // How far its furthest corner is inside, in units.
  double highest(const HalfSpace& space) const {
    return space.above(center) + glm::dot(glm::abs(space.normal), half_size);
  }
};

struct PortalGraph {
  std::size_t cluster_count = 0;
  std::vector<DirectedPortal> portals;   // 2 * i and 2 * i + 1 are one opening's two directions
  std::vector<ClusterBox> boxes;         // by cluster
  std::vector<std::uint32_t> first_out;  // by cluster, and one more: where its part of `out` begins
  std::vector<std::uint32_t> out;        // portals by the cluster that they leave

  std::span<const std::uint32_t> out_of(std::size_t cluster) const {
    return std::span(out).subspan(first_out[cluster], first_out[cluster + 1] - first_out[cluster]);
  }
};

// Openings with so many corners that cutting them would overflow a Winding become several. Every cluster
// number of the set must be below its cluster_count, every winding have three corners (CHECKed).
PortalGraph make_portal_graph(const PortalSet& set);

}  // namespace temblor::compiler::vis
