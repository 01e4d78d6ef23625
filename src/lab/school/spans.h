// Scan conversion: a triangle as horizontal spans of pixels.
#pragma once

#include <array>
#include <vector>

#include "lab/school/interpolation.h"

namespace temblor::lab::school {

using Corners = std::array<Point, 3>;

// The pixels from `begin` to `end` - 1 of row `y`.
struct Span {
  int y, begin, end;
};

// The pixels whose centers are inside the triangle, in rows from the top. Triangles that share an edge share
// no pixel and leave none out. The corners may come in any order, and lie outside the picture.
std::vector<Span> find_spans(Corners corners, int width, int height);

// A value that changes evenly over a triangle, such as light.
struct Gradient {
  float at_origin = 0, per_x = 0, per_y = 0;

  float at(float x, float y) const { return at_origin + per_x * x + per_y * y; }
};

// The gradient that has these values at the corners; constant for a triangle without area.
Gradient find_gradient(const Corners& corners, const std::array<float, 3>& values);

}  // namespace temblor::lab::school
