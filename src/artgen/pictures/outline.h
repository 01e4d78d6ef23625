// Two-dimensional shapes as signed distance functions. A distance is all that the painter needs to fill a
// shape, to draw an edge or glow around it, and to round and light its rim (canvas.h). Coordinates are
// pixels, x right and y down.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "math/vec.h"

namespace temblor::artgen::pictures {

// A shape. Its functions own copies of their parameters, so an outline is independent of what it was made
// from.
struct Outline {
  // The distance in pixels to the shape's edge, negative inside. It is exact near the edge, except that it
  // may be too small where joined parts overlap.
  std::function<double(math::Vec2d)> distance;
  // A box that contains the inside.
  math::Vec2d mins{0.0}, maxs{0.0};
};

// `rounding` is the corners' radius, limited to half of the shorter side.
Outline make_box(math::Vec2d mins, math::Vec2d maxs, double rounding);
Outline make_ellipse(math::Vec2d middle, math::Vec2d radii);
// A circle line of `width` around `radius`.
Outline make_ring(math::Vec2d middle, double radius, double width);
// A part of a ring from one angle to another, in degrees clockwise from the right, with round ends.
Outline make_arc(math::Vec2d middle, double radius, double width, double from_deg, double to_deg);
// At least 3 corners, in either direction. The polygon may be concave.
Outline make_polygon(std::vector<math::Vec2d> corners);
// Connected lines with flat ends. Each line is `flare` times as wide at its ends as in the middle, like a
// chisel cut. At least 1 point.
Outline make_line(const std::vector<math::Vec2d>& points, double width, double flare);
// Connected lines with round ends. At least 2 points.
Outline make_trace(const std::vector<math::Vec2d>& points, double width);
// Everything below a line that is given by its heights at x = 0, 1, 2, and so on. At least 2 heights.
Outline make_ground(std::vector<double> tops, double bottom);
// A disc whose radius varies at random by up to +-2 * `rough` times itself. `lump` is the length of the
// bulges in radii.
Outline make_blob(math::Vec2d middle, double radius, double rough, double lump, double seed);

// The shape together with its mirror image at the vertical line at x.
Outline add_mirror_image(Outline outline, double x);
// The union of at least one shape.
Outline join_outlines(std::vector<Outline> outlines);

}  // namespace temblor::artgen::pictures
