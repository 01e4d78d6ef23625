// Pieces of one opening joined again.
#pragma once

#include "compiler/vis/portals.h"

namespace temblor::compiler::vis {

// The tree cuts the opening between two clusters wherever detail behind it was split. Pieces in one plane
// between the same two clusters are joined along common edges as long as they stay convex: fewer ways for
// the flow to follow, and the same openings. The order is that of each opening's first piece.
std::vector<Portal> merge_portals(const std::vector<Portal>& portals);

}  // namespace temblor::compiler::vis
