// Which of a texture's four mip levels a surface is drawn from.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// The original's rule. `nearest` is ViewFrame::depth at the nearest point on the screen; `axes_length` the
// mean length of the face's texture axes, in texels a unit.
int stock_mip(const ViewFrame& view, double nearest, double axes_length);

// From the texels of mip 0 (planes `depth`, `s`, `t`) that a pixel covers at (x, y).
int footprint_mip(const ViewFrame& view, const ScreenPlane& depth, const ScreenPlane& s, const ScreenPlane& t,
                  double x, double y);

// The largest depth of a face within the screen; `corners_world` in any order round.
double nearest_depth(const ViewFrame& view, std::span<const math::Vec3d> corners_world, base::Arena& arena);

}  // namespace temblor::render
