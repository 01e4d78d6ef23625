// The surface of a model before it becomes an alias model: triangles over points that bones move, unrolled
// onto charts.
//
// A chart is a part of the surface that lies flat in a plane, in map units; the atlas (atlas.h) places charts
// on the skin. Mirror images of a shape share the charts of the original.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "artgen/models/skeleton.h"
#include "math/vec.h"

namespace temblor::artgen {

// A vertex position. One bone moves it, or two bones in shares.
struct MeshPoint {
  // The position at rest, in the model's coordinates.
  math::Vec3d rest{0.0};
  std::size_t bone_a = 0, bone_b = 0;
  // The weight of bone_b; bone_a has the rest. 0: bone_a alone.
  double share_b = 0;
};

// A corner of a triangle. Corners of different charts may share a point.
struct MeshCorner {
  std::uint32_t point = 0;
  // The position on the chart, in units.
  math::Vec2d position{0.0};
  // The position on the shape, for patches: from its start (0) to its end (1), and the angle around it from
  // -180 to 180.
  double along = 0;
  double around_deg = 0;
};

// A triangle of the surface.
struct MeshTriangle {
  // Counter-clockwise as seen from outside. MDL files have them clockwise.
  std::array<MeshCorner, 3> corners;
  std::uint32_t chart = 0;
  // The smoothing group: triangles of the same group share normals at common points.
  std::uint32_t smooth = 0;
};

// All shapes of a model. Builders (rings.h, solids.h) append to it.
struct Mesh {
  std::vector<MeshPoint> points;
  std::vector<MeshTriangle> triangles;
  // For each chart: the index of its shape.
  std::vector<std::uint32_t> chart_shapes;
  // For each triangle: whether it is a mirror image, whose chart positions are those of an earlier triangle.
  std::vector<bool> is_image;
  // The number of smoothing groups.
  std::uint32_t smooth_count = 0;
};

// The points' positions in a pose (linear blend skinning). `bones` maps each bone's own coordinates to the
// model's.
std::vector<math::Vec3d> transform_points(const Mesh& mesh, const std::vector<math::Vec3d>& rest_positions,
                                          const std::vector<Transform>& bones);

// The unit normal of a counter-clockwise triangle; straight up if it has no area.
math::Vec3d triangle_normal(const math::Vec3d& a, const math::Vec3d& b, const math::Vec3d& c);

}  // namespace temblor::artgen
