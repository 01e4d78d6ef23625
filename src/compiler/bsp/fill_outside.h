// Finds leaks, and makes the void outside a sealed level solid.
//
// The flood begins at the edge of the tree's box and passes through every portal between leaves that nothing
// opaque fills. It must not reach an entity: qbsp's old trick for telling the inside of a level from the
// outside. A sealed level loses everything outside, faces included, which roughly halves its size.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

// How the outside reaches an occupant.
struct Leak {
  std::size_t entity;                   // index of the occupant that the flood reached
  std::vector<math::Vec3d> path_world;  // from the occupant to the outside, through the centers of portals
};

// Floods the tree from outside. If no occupant is reached, every reached leaf becomes kSolid without brushes,
// and the result is empty. If one is reached, or if there are none, nothing changes. Occupants inside opaque
// leaves are never reached.
std::optional<Leak> fill_outside(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                                 std::span<const math::Vec3d> occupants);

}  // namespace temblor::compiler
