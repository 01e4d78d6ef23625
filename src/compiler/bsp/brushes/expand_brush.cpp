#include "compiler/bsp/brushes/expand_brush.h"

#include <algorithm>
#include <cmath>

namespace temblor::compiler {
namespace {

// How far a box whose origin is on the plane reaches behind that plane.
double compute_box_reach(const math::Vec3d& normal, const HullBox& box) {
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis)
    reach -= normal[axis] * (normal[axis] > 0 ? box.mins[axis] : box.maxs[axis]);
  return reach;
}

// How far the brush reaches along a direction.
double find_farthest_along(const Brush& brush, const math::Vec3d& normal) {
  double farthest = -1e30;
  for (const BrushSide& side : brush.sides)
    for (const math::Vec3d& point : side.winding) farthest = std::max(farthest, glm::dot(point, normal));
  return farthest;
}

// Calls body(normal, point) for each plane through an edge of the brush and along an edge of the box: faces
// that the sum may have though neither the brush nor the box has them.
void for_each_edge_normal(const Brush& brush,
                          base::FunctionRef<void(const math::Vec3d&, const math::Vec3d&)> body) {
  for (const BrushSide& side : brush.sides)
    for (std::size_t i = 0; i < side.winding.size(); ++i) {
      const math::Vec3d& point = side.winding[i];
      const math::Vec3d along = side.winding[(i + 1) % side.winding.size()] - point;
      if (glm::dot(along, along) < 0.01) continue;
      for (int axis = 0; axis < 3; ++axis) {
        math::Vec3d box_edge(0.0);
        box_edge[axis] = 1;
        const math::Vec3d across = glm::cross(glm::normalize(along), box_edge);
        const double length = glm::length(across);
        if (length < 0.01) continue;
        body(across / length, point);
        body(-across / length, point);
      }
    }
}

}  // namespace

// Planes that are equal after the move are added once: bevels often coincide with sides.
Brush expand(const Brush& brush, const HullBox& box, PlaneSet& io_planes) {
  Brush grown;
  grown.fill = Fill::kSolid;

  const auto add = [&](const math::Vec3d& normal, double distance, bool is_bevel) {
    const PlaneIndex plane = io_planes.find_or_add(normal, distance + compute_box_reach(normal, box));
    const auto known = [&](const BrushSide& side) { return side.plane == plane; };
    if (std::any_of(grown.sides.begin(), grown.sides.end(), known)) return;
    grown.sides.push_back({plane, is_bevel ? kNoSurface : 0u});
  };
  for (const BrushSide& side : brush.sides) {
    const Plane plane = io_planes[side.plane];
    add(plane.normal, plane.distance, false);
  }
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      math::Vec3d normal(0.0);
      normal[axis] = sign;
      add(normal, find_farthest_along(brush, normal), true);
    }
  // An edge plane is a face of the sum only if the whole brush is behind it.
  for_each_edge_normal(brush, [&](const math::Vec3d& normal, const math::Vec3d& point) {
    const double distance = glm::dot(point, normal);
    if (find_farthest_along(brush, normal) <= distance + kOnPlaneEpsilon) add(normal, distance, true);
  });
  return grown;
}

void add_windings(Brush& io_grown, const PlaneSet& planes) {
  make_windings(io_grown.sides, planes, io_grown.box);
  std::erase_if(io_grown.sides, [](const BrushSide& side) { return side.winding.empty(); });
}

}  // namespace temblor::compiler
