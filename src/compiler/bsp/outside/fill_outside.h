// Finds leaks, and makes solid what nobody can reach or see: the void outside a sealed level, and pockets in
// it.
//
// A flood begins at the edge of the tree's box and passes through every portal between leaves that no opaque
// structural brush fills, if the portal is at least 0.12 units wide. It must not reach an entity: qbsp's old
// trick for telling the inside of a level from the outside. A sealed level loses everything outside, faces
// included, which roughly halves its size. A second flood begins at the entities and finds the pockets, which
// it does not reach.
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
// leaves are never reached, nor are those within 1 unit (a little more in corners) of the inside. One on the
// outer side of a brush counts only if no occupant is inside.
std::optional<Leak> fill_outside(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                                 std::span<const math::Vec3d> occupants);

// Makes each leaf solid that no flood from an occupant or from a brush of an entity reaches. Does nothing if
// all of them are inside brushes. To be called for the drawn hull of a sealed level; clip hulls keep such
// places, because a game may move a player into them.
void fill_pockets(Tree& io_tree, const PlaneSet& planes, const LeafPortals& portals,
                  std::span<const math::Vec3d> occupants, std::span<const Box> entity_brushes);

}  // namespace temblor::compiler
