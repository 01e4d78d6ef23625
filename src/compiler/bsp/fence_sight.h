// Who sees what lies wholly behind a fence: the fence is no leaf of the level, so it is marked in those
// around.
#pragma once

#include <span>
#include <vector>

#include "compiler/bsp/faces/faces.h"
#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

// Faces that only fences' leaves see get the leaves that touch those fences, in order; others stay as they
// are.
void mark_around_fences(std::span<TreeFace> io_faces, const Tree& tree, std::span<const LeafPortal> portals);

}  // namespace temblor::compiler
