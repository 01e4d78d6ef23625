// The convex hull of two polygons in one plane.
#pragma once

#include "compiler/vis/flow/winding.h"

namespace temblor::compiler::vis {

// Whether no corner of `inner` is outside `outer` by more than kEpsilon. Both are in the plane with that
// normal, clockwise seen from in front.
bool contains(const Winding& outer, const Winding& inner, const math::Vec3d& normal);

// Replaces io_winding by the hull of both, also clockwise. Returns false, and leaves it unchanged, if the
// hull has more than kMaxWindingPoints corners.
bool grow_hull(Winding& io_winding, const Winding& other, const math::Vec3d& normal);

}  // namespace temblor::compiler::vis
