// What lies outside of a level is made solid, and a level that is not closed is found out.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

struct Leak {
  std::size_t entity;                  // which of the occupants is reached
  std::vector<math::Vec3d> way_world;  // from it to the outside, through the middles of portals
};

// Floods the tree from outside, through leaves that nothing opaque fills. When no occupant (a point that is
// not in an opaque leaf) is reached, all that was reached becomes kSolid, filled by nothing; otherwise, and
// without occupants, nothing changes.
std::optional<Leak> fill_outside(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                                 std::span<const math::Vec3d> occupants);

}  // namespace temblor::compiler
