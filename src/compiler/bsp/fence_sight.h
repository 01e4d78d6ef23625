// Faces inside a fence (func_detail_fence: bars, grates), which are seen through its holes. The fence is
// solid, so its leaves are not leaves of the level, and the faces must be listed in the leaves around it.
#pragma once

#include <span>
#include <vector>

#include "compiler/bsp/faces/faces.h"
#include "compiler/bsp/leaf_portals.h"

namespace temblor::compiler {

// If all leaves that see a face are a fence's, replaces them by the open leaves that touch that fence, in
// order. Other faces stay unchanged.
void mark_around_fences(std::span<TreeFace> io_faces, const Tree& tree, std::span<const LeafPortal> portals);

}  // namespace temblor::compiler
