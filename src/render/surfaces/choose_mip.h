// Chooses which of a texture's four mip levels a surface is drawn from. Two rules: stock Quake's, by distance
// (Abrash, "Quake's Lighting Model: Surface Caching"), and one by the texels that a pixel covers, which also
// reduces aliasing on slanted faces.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Stock Quake's rule. `nearest` is ViewFrame::depth at the face's nearest point on the screen; `axes_length`
// is the mean length of the face's texture axes, in texels per unit.
int stock_mip(const ViewFrame& view, double nearest, double axes_length);

// By the number of texels of mip 0 (planes `depth`, `s`, `t`) that the pixel at (x, y) covers.
int footprint_mip(const ViewFrame& view, const ScreenPlane& depth, const ScreenPlane& s, const ScreenPlane& t,
                  double x, double y);

// The largest depth of a face within the frustum. `corners_world` is its polygon, in either direction.
double nearest_depth(const ViewFrame& view, std::span<const math::Vec3d> corners_world, base::Arena& arena);

}  // namespace temblor::render
