// Joins the pieces of one opening.
#pragma once

#include "compiler/vis/portals.h"

namespace temblor::compiler::vis {

// The tree cuts the opening between two clusters wherever it splits the detail on the other side. Joins
// pieces in one plane between the same two clusters along common edges as long as they stay convex: the
// openings stay the same, but the search has fewer chains to follow. The order is that of each opening's
// first piece.
std::vector<Portal> merge_portals(const std::vector<Portal>& portals);

}  // namespace temblor::compiler::vis
