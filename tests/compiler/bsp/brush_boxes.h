// Brushes as convex solids, computed from the map's text alone, and boxes against them.
#pragma once

#include <vector>

#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::test {

struct Solid {
  std::vector<math::Vec3d> corners, normals, edges;  // edges: unit directions
  std::vector<double> distances;                     // of the planes, by normal
  math::Vec3d mins{1e9}, maxs{-1e9};
  bool stops_points = true;  // false: clip and sky stop only boxes
};

Solid make_brush_solid(const formats::MapBrush& brush);

// Everything that stops boxes in the world, func_group and solid func_detail kinds.
std::vector<Solid> solids_of_world(const formats::Map& map);

// Relative to the box's origin.
struct HullBox {
  math::Vec3d mins, maxs;
};

// Every axis that can separate two convex bodies, the solid and a box: the solid's normals, the box's, and
// the cross products of their edges (the separating axis theorem).
std::vector<math::Vec3d> separating_axes(const Solid& solid);

// How deep the box at `at` is in the solid, along the axis that separates them best; negative: the distance
// along it.
double depth_in(const Solid& solid, const HullBox& box, const math::Vec3d& at);

// The time at which the box, moving from `start` (time 0) to `end` (time 1), is first nearer to the solid
// than `gap` on every axis (negative gap: that deep inside it); 2 if it never is.
double time_of_contact(const Solid& solid, const HullBox& box, const math::Vec3d& start,
                       const math::Vec3d& end, double gap);

}  // namespace temblor::test
