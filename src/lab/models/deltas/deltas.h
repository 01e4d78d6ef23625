// Models by a walk around their visible side: it begins at a seed, the nearest front triangle, and goes on
// from neighbor to neighbor across edges. The steps along an edge from row to row, its deltas, are computed
// once, and the neighbor reuses them.
//
//     seed /\        The walk ends at the outline. Front triangles that no chain of front triangles joins to
//     ____/__\____   the seed, such as an arm before a body, need a seed of their own.
//     \  /\  /\  /
//      \/__\/__\/
//
// Models that reach behind the eye are drawn by the engine. Pixels are those of scan lines.
//
// Parameter `seeds`: 1: one for each model; 0: as many as it needs.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_deltas(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
