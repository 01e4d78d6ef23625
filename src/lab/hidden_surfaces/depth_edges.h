// Edge sorting by 1/z instead of BSP order, for the whole world. The three types of Abrash's "Sorted Spans in
// Action":
//
//   independent   one comparison of 1/z where a surface begins: right only if surfaces do not touch
//   abutting      nearly equal depths count as equal, and the surface whose 1/z grows faster to the right is
//                 in front. Parameters: `epsilon`, the relative difference that counts as equal; `gradient` 0
//                 leaves out the second rule; `mesh` 1: across a shared edge, the new surface takes the place
//                 of the old one, without a comparison
//   intersecting  depths are compared at every interval between two edges, and spans are split where surfaces
//                 cross
//
// The article also mentions caches for abutting edges, because two faces that do not cross are always in the
// same order: cached-order (pair_orders.h). Parameters: `pairs`, the places of the
// cache; `keep` 0 empties it before each frame.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_independent_edges(std::span<const double> values, Counter* counter);
render::FrameStages make_abutting_edges(std::span<const double> values, Counter* counter);
render::FrameStages make_intersecting_edges(std::span<const double> values, Counter* counter);
render::FrameStages make_cached_order(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
