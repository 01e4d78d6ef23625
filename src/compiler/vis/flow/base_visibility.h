// A first bound on what is seen through each portal, from the sides of planes alone.
#pragma once

#include "base/parallel_for.h"
#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/flow/portal_graph.h"

namespace temblor::compiler::vis {

// Row: portal of the graph; column: cluster that might be seen through it. A portal might be seen through
// another when some of it lies beyond that one, some of that one lies behind it, and a way of such portals
// leads to it.
BitMatrix find_base_visibility(const PortalGraph& graph, base::Jobs& jobs);

}  // namespace temblor::compiler::vis
