// The faces of one model, for ray tests: polygons and planes in double precision, in a tree of boxes that
// only saves time (a test compares it with testing every face).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "math/vec.h"
#include "oracle/rays/camera_rays.h"
#include "world/level.h"

namespace temblor::oracle {

struct FaceHit {
  world::FaceIndex face;
  double distance;  // in multiples of the ray's direction
};

class FaceTree {
 public:
  FaceTree(const world::Level& level, const world::Model& model);

  // The nearest face at `min_distance` or beyond whose front the ray meets and that `accept` accepts.
  using Accept = base::FunctionRef<bool(const FaceHit&)>;
  std::optional<FaceHit> nearest(const Ray& ray, double min_distance, Accept accept) const;

  // The distance at which the ray meets the front of the given face, on either side of the ray's origin;
  // nothing if it does not meet it, or if the face is not in this model.
  std::optional<double> distance_to(const Ray& ray, world::FaceIndex face) const;

 private:
  struct Polygon {
    world::FaceIndex face;
    math::Vec3d normal;  // towards the side from which it is seen
    double plane_distance;
    int dropped_axis;  // the normal's largest: the polygon is judged in the other two
    std::uint32_t first_vertex, vertex_count;
  };
  struct Box {
    math::Vec3d mins{1e30}, maxs{-1e30};
  };
  struct Node {
    Box box;
    std::uint32_t first, count;   // polygons; count 0: not a leaf of the tree
    std::uint32_t children[2]{};  // of a node with count 0
  };

  std::span<const math::Vec3d> list_vertices(const Polygon& polygon) const {
    return std::span(vertices_).subspan(polygon.first_vertex, polygon.vertex_count);
  }
  std::optional<double> meet(const Ray& ray, const Polygon& polygon) const;
  Box measure_bounds(const Polygon& polygon) const;
  std::uint32_t build(std::uint32_t first, std::uint32_t count);

  std::vector<Polygon> polygons_;
  std::vector<math::Vec3d> vertices_;
  std::vector<Node> nodes_;  // the root is nodes_[0]; empty when the model has no face
};

}  // namespace temblor::oracle
