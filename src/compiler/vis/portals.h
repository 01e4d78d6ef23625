// Portals: the openings between the clusters of a level, the input of the visibility stage.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

// The cluster of a solid leaf.
constexpr std::uint32_t kNoCluster = std::numeric_limits<std::uint32_t>::max();

// A convex polygon in a plane. It has at least three corners, clockwise seen from in front of the plane.
struct Portal {
  std::vector<math::Vec3d> winding_world;
  math::Vec3d normal{0.0};
  double distance = 0;
  std::array<std::uint32_t, 2> clusters{};  // in front of the plane, behind it
};

// A cluster is a leaf, or several leaves into which detail brushes split one; they see, and are seen,
// together.
struct PortalSet {
  std::uint32_t cluster_count = 0;
  std::vector<Portal> portals;
  std::vector<std::uint32_t> cluster_of_leaf;  // by leaf of the level, including leaf 0; kNoCluster: solid
};

}  // namespace temblor::compiler
