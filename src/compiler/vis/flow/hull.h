// The convex hull of two polygons in one plane.
#pragma once

#include "compiler/vis/flow/winding.h"

namespace temblor::compiler::vis {

// Whether no corner of `inner` lies outside `outer` by more than kEpsilon. Both lie in the plane with that
// normal, clockwise seen from in front of it.
bool contains(const Winding& outer, const Winding& inner, const math::Vec3d& normal);

// io_winding becomes the hull of both, clockwise as they are. False, and it is as it was, when the hull has
// more than kMaxWindingPoints corners.
bool grow_hull(Winding& io_winding, const Winding& other, const math::Vec3d& normal);

}  // namespace temblor::compiler::vis
