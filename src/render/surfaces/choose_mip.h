// Chooses which of a texture's mip levels, `finest` (0 or below) to 3, a surface is drawn from. Two rules:
// stock Quake's, by distance (Abrash, "Quake's Lighting Model: Surface Caching"), and one by the texels that
// a pixel covers, which also reduces aliasing on slanted faces.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Linear on the screen: 1/z, and the coordinates in texels of mip 0 (over z, in perspective).
struct TexturePlanes {
  ScreenPlane depth, s, t;
};

// Stock Quake's rule. `nearest` is ViewFrame::depth at the face's nearest point on the screen; `axes_length`
// is the mean length of the face's texture axes, in texels per unit.
int stock_mip(const ViewFrame& view, double nearest, double axes_length, int finest);

// By the number of texels of mip 0 that the pixel at (x, y) covers.
int footprint_mip(const ViewFrame& view, const TexturePlanes& planes, double x, double y, int finest);

// The largest depth of a face within the frustum. `corners_world` is its polygon, in either direction.
double nearest_depth(const ViewFrame& view, std::span<const math::Vec3d> corners_world, base::Arena& arena);

}  // namespace temblor::render
