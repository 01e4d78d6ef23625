// The tree that a level gets. The first tree of a model is cut by every side of every brush, most of which
// are buried in solid or outside the level. The second tree uses only the sides at which contents change or a
// face is visible.
#pragma once

#include <span>
#include <vector>

#include "compiler/bsp/faces/faces.h"
#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

// A tree and its portals.
struct SecondTree {
  Tree tree;
  LeafPortals portals;
};

// `first` and `portals`: the first tree after its outside was filled. `brushes`: the brushes that the tree
// was made of.
SecondTree make_second_tree(const Tree& first, std::span<const LeafPortal> portals,
                            std::span<const Brush> brushes, const PlaneSet& planes);

// Cuts faces by a tree, moves each down to the node in whose plane it is, and finds the leaves that see it.
std::vector<TreeFace> place_faces(std::span<const TreeFace> faces, const Tree& tree, const PlaneSet& planes);

}  // namespace temblor::compiler
