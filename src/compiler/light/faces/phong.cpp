// Method: a corner's normal is the sum of the normals of the faces around that vertex that belong together,
// each weighted by its angle there. In between, normals are blended by mean value coordinates (Floater, "Mean
// value coordinates", 2003), which are linear along each edge, so neighbors agree on it.
#include "compiler/light/faces/phong.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "world/face_at.h"

namespace temblor::compiler {
namespace {

// A face at one of its corners.
struct FaceCorner {
  std::size_t face = 0;
  math::Vec3d normal{0.0};
  double angle_rad = 0;           // between the two edges
  math::Vec3d center_world{0.0};  // of the face
};

double compute_angle_between(const math::Vec3d& a, const math::Vec3d& b) {
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0, 1.0)) : 0;
}

math::Vec3d find_center(std::span<const math::Vec3d> corners) {
  math::Vec3d sum(0.0);
  for (const math::Vec3d& corner : corners) sum += corner;
  return sum / static_cast<double>(corners.size());
}

// Two faces belong together if they bend by no more than both allow.
bool belong_together(const LitLevel& lit, const FaceCorner& a, const FaceCorner& b) {
  const SurfaceKeys& keys_a = lit.surface_keys(a.face);
  const SurfaceKeys& keys_b = lit.surface_keys(b.face);
  if (keys_a.phong_group != keys_b.phong_group || lit.model_of_face[a.face] != lit.model_of_face[b.face])
    return false;
  // Concave if one face's center is in front of the other's plane.
  const bool concave = glm::dot(b.center_world - a.center_world, a.normal) > 0;
  const auto allowed_deg = [&](const SurfaceKeys& keys) {
    return concave && keys.phong_angle_concave_deg > 0 ? keys.phong_angle_concave_deg : keys.phong_angle_deg;
  };
  const double allowed_rad =
      double{std::min(allowed_deg(keys_a), allowed_deg(keys_b))} * std::numbers::pi / 180;
  constexpr double kRounding = 1e-4;
  return compute_angle_between(a.normal, b.normal) <= allowed_rad + kRounding;
}

// The tangent of half the angle between two directions.
double compute_half_tangent(const math::Vec3d& a, const math::Vec3d& b) {
  return std::tan(compute_angle_between(a, b) / 2);
}

}  // namespace

// Sorts all corners by their vertex, then sums the normals around each vertex.
PhongNormals::PhongNormals(const LitLevel& lit) : corner_normals_(lit.level->faces.size()) {
  const world::Level& level = *lit.level;
  std::map<std::uint32_t, std::vector<FaceCorner>> around_vertex;
  const auto find_vertex = [&](const world::Face& face, std::size_t i) {
    return level.surfedge_start(face.first_surfedge + i % face.surfedge_count);
  };
  for (std::size_t number = 0; number < level.faces.size(); ++number) {
    if (!lit.gets_light[number] || lit.surface_keys(number).phong_angle_deg <= 0) continue;
    const world::Face& face = level.faces[number];
    const std::vector<math::Vec3d> corners = lit.corners_world(number);
    const math::Vec3d center = find_center(corners);
    const math::Vec3d normal = world::compute_face_plane(level, face).normal;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const math::Vec3d next = corners[(i + 1) % corners.size()] - corners[i];
      const math::Vec3d last = corners[(i + corners.size() - 1) % corners.size()] - corners[i];
      around_vertex[find_vertex(face, i)].push_back(
          {number, normal, compute_angle_between(next, last), center});
    }
  }
  for (const auto& [vertex, around] : around_vertex)
    for (const FaceCorner& corner : around) {
      math::Vec3d sum(0.0);
      for (const FaceCorner& other : around)
        if (other.face == corner.face || belong_together(lit, corner, other))
          sum += other.normal * other.angle_rad;
      const world::Face& face = level.faces[corner.face];
      std::vector<math::Vec3d>& normals = corner_normals_[corner.face];
      if (normals.empty()) normals.assign(face.surfedge_count, corner.normal);
      const double length = glm::length(sum);
      for (std::size_t i = 0; length > 0 && i < face.surfedge_count; ++i)
        if (find_vertex(face, i) == vertex) normals[i] = sum / length;
    }
}

math::Vec3 PhongNormals::at(const LightGrid& grid, const math::Vec3d& point_world) const {
  const std::vector<math::Vec3d>& normals = corner_normals_[grid.face];
  if (normals.empty()) return math::Vec3(grid.normal);
  const std::vector<math::Vec3d>& corners = grid.corners_world;
  const std::size_t count = corners.size();
  // Where the grid sticks out of the face, the nearest corner or edge decides.
  math::Vec3d point = point_world - grid.normal * glm::dot(grid.normal, point_world - corners[0]);
  for (std::size_t i = 0; i < count; ++i) {
    const math::Vec3d way = corners[(i + 1) % count] - corners[i], outward = glm::cross(grid.normal, way);
    const double outside = glm::dot(point - corners[i], outward);
    if (outside > 0) point -= outward * (outside / glm::dot(outward, outward));
  }
  constexpr double kAtCorner = 1e-3;
  for (std::size_t i = 0; i < count; ++i)
    if (glm::length(corners[i] - point) < kAtCorner) return math::Vec3(normals[i]);
  math::Vec3d sum(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const math::Vec3d to = corners[i] - point, to_next = corners[(i + 1) % count] - point,
                      to_last = corners[(i + count - 1) % count] - point;
    const double weight =
        (compute_half_tangent(to_last, to) + compute_half_tangent(to, to_next)) / glm::length(to);
    sum += normals[i] * weight;
  }
  const double length = glm::length(sum);
  return math::Vec3(length > 0 ? sum / length : grid.normal);
}

}  // namespace temblor::compiler
