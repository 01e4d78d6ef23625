// A model's surface before it becomes frames and a skin: triangles over points that bones carry, unrolled on
// charts.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "artgen/models/skeleton.h"
#include "math/vec.h"

namespace temblor::artgen {

// Carried by two bones in parts, or by one alone (share_b 0).
struct MeshPoint {
  math::Vec3d rest{0.0};  // the model's space
  std::size_t bone_a = 0, bone_b = 0;
  double share_b = 0;
};

struct MeshCorner {
  std::uint32_t point = 0;
  math::Vec2d place{0.0};  // on its chart, in units
  double along = 0;        // 0 to 1: from the shape's beginning to its end
  double around_deg = 0;   // -180 to 180
};

struct MeshTriangle {
  std::array<MeshCorner, 3> corners;  // counter-clockwise seen from outside
  std::uint32_t chart = 0;
  std::uint32_t smooth = 0;  // triangles of one number share normals where they share points
};

struct Mesh {
  std::vector<MeshPoint> points;
  std::vector<MeshTriangle> triangles;
  std::vector<std::uint32_t> chart_shapes;  // by chart: the number of its shape
  // Triangles from here on, mirror images, lie on the same places of charts as earlier ones.
  std::vector<bool> is_image;  // by triangle
  std::uint32_t smooth_count = 0;
};

// Where the points are when the bones are.
std::vector<math::Vec3d> place_points(const Mesh& mesh, const std::vector<math::Vec3d>& rest_places,
                                      const std::vector<Transform>& bones);

math::Vec3d triangle_normal(const math::Vec3d& a, const math::Vec3d& b, const math::Vec3d& c);

}  // namespace temblor::artgen
