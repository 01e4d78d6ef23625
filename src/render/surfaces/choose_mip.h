// Which of a texture's four mip levels a surface is drawn from.
#pragma once

#include <span>

#include "base/arena.h"
#include "render/renderer.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// `depth`, `s`, `t`: of mip 0; `nearest` is ViewFrame::depth at the nearest visible point. `axes_length`:
// mean length of the face's texture axes, in texels a unit.
int choose_mip(MipRule rule, const ViewFrame& view, const ScreenPlane& depth, const ScreenPlane& s,
               const ScreenPlane& t, double nearest, double axes_length);

// The largest depth of a face within the screen; `corners_world` in any order round.
double nearest_depth(const ViewFrame& view, std::span<const math::Vec3d> corners_world, base::Arena& arena);

}  // namespace temblor::render
