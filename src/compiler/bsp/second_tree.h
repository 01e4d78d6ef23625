// A tree of what bounds something. The first tree of a model is cut by every side of every brush, most of
// which lie in solid, or outside. It says what is where; the second one is cut only where that changes.
#pragma once

#include <span>
#include <vector>

#include "compiler/bsp/faces/faces.h"
#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

struct SecondTree {
  Tree tree;
  LeafPortals portals;
};

// `first` with its portals, after outside was filled; its leaves' places in `brushes`.
SecondTree make_second_tree(const Tree& first, std::span<const LeafPortal> portals,
                            std::span<const Brush> brushes, const PlaneSet& planes);

// Cuts faces by a tree, down to the node in whose plane each lies, and finds the leaves that see it.
std::vector<TreeFace> place_faces(std::span<const TreeFace> faces, const Tree& tree, const PlaneSet& planes);

}  // namespace temblor::compiler
