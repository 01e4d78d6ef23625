// Where a tree's leaves touch: a polygon for each pair of neighbors.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/bsp/tree.h"

namespace temblor::compiler {

struct LeafPortal {
  Winding winding;  // seen from the first leaf
  std::uint32_t node;
  std::array<std::uint32_t, 2> leaves;  // in front of the node's plane, behind it
};

struct LeafPortals {
  std::vector<LeafPortal> portals;
  std::vector<bool> is_outermost;  // by leaf: it reaches the end of the tree's box
};

LeafPortals make_leaf_portals(const Tree& tree, const PlaneSet& planes);

}  // namespace temblor::compiler
