// The openings between the clusters of a level: what can be seen through.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

constexpr std::uint32_t kNoCluster = std::numeric_limits<std::uint32_t>::max();

// A convex polygon in a plane; its corners run clockwise seen from in front of the plane, at least three.
struct Portal {
  std::vector<math::Vec3d> winding_world;
  math::Vec3d normal{0.0};
  double distance = 0;
  std::array<std::uint32_t, 2> clusters{};  // in front of the plane, behind it
};

// A cluster is a leaf, or several that detail brushes split, which are seen together.
struct PortalSet {
  std::uint32_t cluster_count = 0;
  std::vector<Portal> portals;
  std::vector<std::uint32_t> cluster_of_leaf;  // by leaf of the level, leaf 0 included; kNoCluster: solid
};

}  // namespace temblor::compiler
