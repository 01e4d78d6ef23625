#include "artgen/models/mesh.h"

namespace temblor::artgen {

std::vector<math::Vec3d> transform_points(const Mesh& mesh, const std::vector<math::Vec3d>& rest_positions,
                                          const std::vector<Transform>& bones) {
  std::vector<math::Vec3d> positions;
  positions.reserve(mesh.points.size());
  for (const MeshPoint& point : mesh.points) {
    const math::Vec3d by_a = bones[point.bone_a](point.rest - rest_positions[point.bone_a]);
    const math::Vec3d by_b = bones[point.bone_b](point.rest - rest_positions[point.bone_b]);
    positions.push_back(by_a * (1 - point.share_b) + by_b * point.share_b);
  }
  return positions;
}

math::Vec3d triangle_normal(const math::Vec3d& a, const math::Vec3d& b, const math::Vec3d& c) {
  const math::Vec3d normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  return length > 0 ? normal / length : math::Vec3d(0, 0, 1);
}

}  // namespace temblor::artgen
