// Brushes as convex solids, worked out from the map's text alone, and boxes against them.
#pragma once

#include <vector>

#include "formats/levels/map.h"
#include "math/vec.h"

namespace temblor::test {

struct Solid {
  std::vector<math::Vec3d> corners, normals, edges;  // edges: unit directions
  std::vector<double> distances;                     // of the planes, by normal
  math::Vec3d mins{1e9}, maxs{-1e9};
  bool stops_points = true;  // false: clip and sky stop boxes alone
};

Solid solid_of(const formats::MapBrush& brush);

// What stops boxes in the world, func_group and solid func_detail kinds.
std::vector<Solid> solids_of_world(const formats::Map& map);

// Seen from the box's origin.
struct HullBox {
  math::Vec3d mins, maxs;
};

// Every axis on which two convex bodies, the solid and a box, can be apart when they do not touch: the
// solid's normals, the box's, and what is perpendicular to an edge of each.
std::vector<math::Vec3d> separating_axes(const Solid& solid);

// How deep the box at `at` is in the solid: by the separating axis that parts them most, or least overlaps;
// negative: how far apart along it.
double depth_in(const Solid& solid, const HullBox& box, const math::Vec3d& at);

// When the box, on its way from `start` (time 0) to `end` (time 1), is first nearer to the solid than `gap`
// on every axis (negative: when it is so deep in it); 2 when it never is.
double time_of_contact(const Solid& solid, const HullBox& box, const math::Vec3d& start,
                       const math::Vec3d& end, double gap);

}  // namespace temblor::test
