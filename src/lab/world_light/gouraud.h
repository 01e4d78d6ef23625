// Gouraud shading of the world: light at the corners of faces, interpolated on the screen. It depends on the
// view, because polygons are clipped first, and because light is linear on the screen and not on the wall.
//
//   perspective=1  light is linear on the wall
//   triangles=1    faces are cut into triangles first, so that light does not depend on the rotation
//   spot=1         cut at the brightest sample of the light map: the place under a light
//   cut=N          cut into a grid of N texels
//
// Vertices get the light that the light map has there. lit_draws.h says what is left out.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_gouraud(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
