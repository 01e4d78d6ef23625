// Floods the leaves of a tree through its portals.
//
// Openings that are too narrow stop the flood. An opening is a portal, or a leaf, or the narrow part of a
// leaf, between two planes that are as near to each other: the flood crosses it only from one plane to the
// other, never along them. Depends on nothing but the tree, so trees of drawn and clip hulls are flooded
// alike.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

constexpr std::uint32_t kNoPortal = std::numeric_limits<std::uint32_t>::max();

// A breadth-first search, so that the way back to the first leaves is a short one.
struct Flood {
  // By leaf. A leaf of which only a narrow part was crossed is not reached.
  std::vector<bool> reached;
  // By leaf: the portal through which the flood first came to it; kNoPortal: it is one of the first leaves,
  // or the flood did not come to it.
  std::vector<std::uint32_t> through;
};

// Whether a leaf stops floods: an opaque brush that is no detail fills it, even if detail overlaps that
// brush.
inline bool is_sealed(const TreeLeaf& leaf) {
  return is_opaque(leaf.fill) || is_opaque(leaf.structure);
}

// Floods all leaves that are not sealed, through openings of at least that width in units.
Flood flood_leaves(const Tree& tree, const PlaneSet& planes, const LeafPortals& portals,
                   std::span<const std::uint32_t> first_leaves, double min_opening_units);

}  // namespace temblor::compiler
