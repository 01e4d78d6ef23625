#include "world/face_at.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace temblor::world {

namespace {

// Units. Compilers round vertices, so a face may extend slightly beyond its node's space.
constexpr double kSlack = 0.1;

math::Vec3d face_vertex(const Level& level, const Face& face, std::uint32_t i) {
  return math::Vec3d(level.vertices[level.surfedge_start(face.first_surfedge + i % face.surfedge_count)]);
}

// Returns the nearest point of a line segment, which may have no length.
math::Vec3d find_nearest_on_segment(const math::Vec3d& start, const math::Vec3d& end,
                                    const math::Vec3d& point) {
  const math::Vec3d way = end - start;
  const double length_squared = glm::dot(way, way);
  if (!(length_squared > 0)) return start;
  return start + way * std::clamp(glm::dot(point - start, way) / length_squared, 0.0, 1.0);
}

}  // namespace

FacePlane compute_face_plane(const Level& level, const Face& face) {
  const Plane& plane = level.planes[face.plane];
  const double side = face.back_side ? -1 : 1;
  return {math::Vec3d(plane.normal) * side, double{plane.distance} * side};
}

// If the point's foot on the plane is inside of the polygon, it is the nearest point. Otherwise the nearest
// point is on the boundary: the nearest of all edges wins.
math::Vec3d find_nearest_point(const Level& level, const Face& face, const math::Vec3d& point) {
  const FacePlane plane = compute_face_plane(level, face);
  const math::Vec3d foot = point - plane.normal * (glm::dot(plane.normal, point) - plane.distance);
  bool inside = face.surfedge_count >= 3;
  math::Vec3d nearest = face_vertex(level, face, 0);
  double nearest_squared = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i) {
    const math::Vec3d start = face_vertex(level, face, i), end = face_vertex(level, face, i + 1);
    // Vertices run clockwise seen from the front, so the inside is to the right of every edge.
    inside = inside && glm::dot(glm::cross(end - start, foot - start), plane.normal) <= 0;
    const math::Vec3d candidate = find_nearest_on_segment(start, end, foot), away = foot - candidate;
    if (const double squared = glm::dot(away, away); squared < nearest_squared) {
      nearest_squared = squared;
      nearest = candidate;
    }
  }
  return inside ? foot : nearest;
}

std::span<const NearFace> NearFaceFinder::find(const Level& level, ModelIndex model, const math::Vec3d& point,
                                               double reach) {
  found_.clear();
  // An explicit stack: members keep their memory, and deep trees cannot overflow it.
  to_visit_.assign(1, level.models[base::to_size(model)].head);
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
      const FacePlane plane = compute_face_plane(level, face);
      const double in_front = glm::dot(plane.normal, point) - plane.distance;
      if (in_front < -kMaxDistanceBehind) continue;
      const math::Vec3d nearest = find_nearest_point(level, face, point);
      const double away = glm::length(point - nearest);
      if (away <= reach) found_.push_back({base::to_index<FaceIndex>(i), nearest, away, in_front});
    }
  }
  return found_;
}

}  // namespace temblor::world
