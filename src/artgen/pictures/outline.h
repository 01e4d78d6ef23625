// Shapes in the plane, as distances: what the painter fills, rounds and lights.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace temblor::artgen::pictures {

// Pixels, x right and y down.
struct Outline {
  // To the shape's edge: below 0 inside. Near the edge it is exact, or too small for parts that overlap.
  std::function<double(math::Vec2d)> distance;
  math::Vec2d mins{0.0}, maxs{0.0};  // all of the inside
};

Outline make_box(math::Vec2d mins, math::Vec2d maxs, double rounding);
Outline make_ellipse(math::Vec2d middle, math::Vec2d radii);
Outline make_ring(math::Vec2d middle, double radius, double width);
// From angle to angle, in degrees clockwise from the right.
Outline make_arc(math::Vec2d middle, double radius, double width, double from_deg, double to_deg);
Outline make_polygon(std::vector<math::Vec2d> corners);  // at least 3
// Joined lines with flat ends; each line is `flare` times wider at its ends than in its middle, as cut with a
// chisel.
Outline make_line(const std::vector<math::Vec2d>& points, double width, double flare);
Outline make_trace(const std::vector<math::Vec2d>& points,
                   double width);  // the same, round; 2 points or more
// What lies below a line from left to right, given by its heights at whole pixels from x = 0 on.
Outline make_ground(std::vector<double> tops, double bottom);
// A disc whose radius wanders by +- `rough` of itself, in lumps as long as `lump` radii.
Outline make_blob(math::Vec2d middle, double radius, double rough, double lump, double seed);

// The same mirrored about the vertical line at x, and both together.
Outline with_mirror(Outline outline, double x);
Outline joined(std::vector<Outline> outlines);  // at least one

}  // namespace temblor::artgen::pictures
