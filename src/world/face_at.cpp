// Method: the tree is walked down to every node whose plane is within reach. A face lies in its node's plane,
// and every part of space within reach of the point is visited, so no face is missed.
#include "world/face_at.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::world {

namespace {

// Faces stand out of their nodes' space by what compilers round.
constexpr double kSlack = 0.1;

math::Vec3d corner(const Level& level, const Face& face, std::uint32_t i) {
  return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + i % face.surfedge_count)]);
}

math::Vec3d nearest_on_line(const math::Vec3d& start, const math::Vec3d& end, const math::Vec3d& point) {
  const math::Vec3d way = end - start;
  const double length_squared = glm::dot(way, way);
  if (!(length_squared > 0)) return start;
  return start + way * std::clamp(glm::dot(point - start, way) / length_squared, 0.0, 1.0);
}

}  // namespace

FacePlane plane_of(const Level& level, const Face& face) {
  const Plane& plane = level.planes[face.plane];
  const double side = face.back_side ? -1 : 1;
  return {math::Vec3d(plane.normal) * side, double{plane.distance} * side};
}

math::Vec3d nearest_point(const Level& level, const Face& face, const math::Vec3d& point) {
  const FacePlane plane = plane_of(level, face);
  const math::Vec3d foot = point - plane.normal * (glm::dot(plane.normal, point) - plane.distance);
  bool inside = face.surfedge_count >= 3;
  math::Vec3d nearest = corner(level, face, 0);
  double nearest_squared = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3d start = corner(level, face, i), end = corner(level, face, i + 1);
    // Clockwise from the front: the inside is to the right of every side.
    inside = inside && glm::dot(glm::cross(end - start, foot - start), plane.normal) <= 0;
    const math::Vec3d candidate = nearest_on_line(start, end, foot), away = foot - candidate;
    if (const double squared = glm::dot(away, away); squared < nearest_squared) {
      nearest_squared = squared;
      nearest = candidate;
    }
  }
  return inside ? foot : nearest;
}

std::span<const NearFace> FacesNear::find(const Level& level, const math::Vec3d& point, double reach) {
  found_.clear();
  to_visit_.assign(1, level.world().head);
  while (!to_visit_.empty()) {
    const Child child = to_visit_.back();
    to_visit_.pop_back();
    if (child.is_leaf()) continue;
    const Node& node = level.node(child.node());
    const double distance = distance_to(level.planes[node.plane], point);
    if (distance <= reach + kSlack) to_visit_.push_back(node.children[1]);
    if (distance >= -reach - kSlack) to_visit_.push_back(node.children[0]);
    if (std::abs(distance) > reach + kSlack) continue;
    for (std::uint32_t i = node.first_face; i < node.first_face + node.face_count; ++i) {
      const Face& face = level.faces[i];
      if (face.surfedge_count == 0) continue;
      const FacePlane plane = plane_of(level, face);
      const double in_front = glm::dot(plane.normal, point) - plane.distance;
      if (in_front < -kBehind) continue;
      const math::Vec3d nearest = nearest_point(level, face, point);
      const double away = glm::length(point - nearest);
      if (away <= reach) found_.push_back({base::to_index<FaceIndex>(i), nearest, away, in_front});
    }
  }
  return found_;
}

}  // namespace temblor::world
