// Models as outlines that are filled: the edges between front and back triangles are drawn as lines, and
// the color of these lines and of single vertices floods the inside.
//
//   . # # # .        #  outline: texels and light change along each edge
//   # . o . #        o  a vertex of a front triangle
//   # . . . #        .  inside: the color and depth of the nearest of these, by steps of one pixel
//   . # # # .
//
// Everything within the outer outline is filled, also holes. Vertices and outlines of hidden parts, such as
// an arm behind a body, show through. Models that reach behind the eye or may be larger than the screen, and
// the view model, are drawn as triangles.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_flood_fill(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
