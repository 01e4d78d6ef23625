// An unsplit world: the parts of faces that BSP planes have cut are joined before edges are sorted by 1/z,
// which needs no BSP order. There are fewer edges and fewer surfaces to compare.
//
// A part has its own light map, so each span is cut again where another part begins. (An engine without a BSP
// tree would not split faces, and would save that. It would also save the edges between parts before they are
// projected; here they are removed afterwards.)
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_unsplit_edges(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
