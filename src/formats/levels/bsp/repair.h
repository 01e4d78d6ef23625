// Repair of a damaged level that a game can still play, so that the rules of bsp_validate.h hold again.
#pragma once

#include <cstddef>

#include "formats/levels/bsp.h"

namespace temblor::formats::bsp_file {

// Replaces damaged records that reset_unused() (unused.h) has left. Other engines ignore most of this damage:
//
//   plane      a normal of another length is scaled; one without a direction makes a plane that has all
//              space on one side
//   texinfo    a texture that does not exist becomes a missing one
//   face       left out (clear_faces) if it has a damaged vertex, edge, plane, or texinfo, or fewer than 3 or
//              more than kBspMaxFaceEdges edges; an open outline is closed through its first vertices; any
//              side except 0 is the back; a negative light offset means no light
//   leaf       sees everything if its visibility is not in the lump; unknown contents are empty; leaf 0 is
//              solid
//   node       a child that does not exist becomes leaf 0; a plane that does not exist has all space behind
//              it
//   clipnode   unknown contents are empty; a child that does not exist becomes solid
//   model      bounds that are not finite become those of its faces; the origin becomes 0; a head that does
//              not exist becomes empty space, except the heads that move players in the world: large monsters
//              take those of players; the count of leaves is limited
//   trees      a branch to a node that another one has reached, or below kBspMaxTreeDepth, becomes leaf 0; a
//              head in another model's tree becomes empty space
//   ranges     end at the end of the array, or where the next one begins if they together exceed the array
//
// Returns the number of changed records. Takes time in proportion to the level, except for sorting. The
// result may still have faults: a world without leaves or a tree, planes and cycles of clipnodes.
std::size_t repair_level(Bsp& io_bsp);

}  // namespace temblor::formats::bsp_file
