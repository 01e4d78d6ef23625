// A quick first bound on what is seen through each portal, from the sides of planes alone.
#pragma once

#include "base/parallel_for.h"
#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/flow/portal_graph.h"

namespace temblor::compiler::vis {

// Row: portal of the graph; column: cluster that might be seen through it. Portal B might be seen through
// portal A if some of B is in front of A, some of A is behind B, and a chain of such portals leads from A to
// B. (A flood fill, as in Quake's vis.)
BitMatrix find_base_visibility(const PortalGraph& graph, base::Jobs& jobs);

}  // namespace temblor::compiler::vis
