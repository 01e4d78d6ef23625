// Portals: one convex polygon for each pair of leaves of a tree that touch.
//
// Each node's plane is clipped to the node's volume and pushed down both of its subtrees; every piece that
// arrives at a leaf on both sides is a portal. Faces, the outside flood and the clusters' portals all come
// from these.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "compiler/bsp/tree.h"

namespace temblor::compiler {

// `winding` is clockwise seen from the first leaf.
struct LeafPortal {
  Winding winding;
  std::uint32_t node;                   // the portal is in this node's plane
  std::array<std::uint32_t, 2> leaves;  // in front of the plane, behind it
};

// The part of a face of the tree's box that a leaf touches.
struct LeafExit {
  std::uint32_t leaf;
  int axis;  // on which the face is perpendicular
  Winding winding;
};

// All portals of a tree, in the order of its nodes.
struct LeafPortals {
  std::vector<LeafPortal> portals;
  std::vector<LeafExit> exits;
  std::vector<bool> is_outermost;  // by leaf: it has an exit
};

// Makes the portals of a tree. Tiny ones (is_tiny) are left out.
LeafPortals make_leaf_portals(const Tree& tree, const PlaneSet& planes);

}  // namespace temblor::compiler
