// Geometry of faces, and a search for the faces near a point, for example for bullet holes.
//
// Method: walk the BSP tree of the world or of a brush model, and enter both children of every node whose
// plane is within reach of the point, otherwise only the child on the point's side. A face lies in its node's
// plane, and every part of space within reach of the point is visited, so no face is missed.
//
//             plane          reach > distance to the plane: test the node's faces, visit both sides
//      front    |    back
//         ( *   | )          * point, ( ) its reach
#pragma once

#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

// A face within reach of a query point.
struct NearFace {
  FaceIndex face{};
  math::Vec3d nearest{0.0};  // the point of the face that is nearest to the query point
  double distance = 0;       // between these two points, in units
  // Signed distance of the query point from the face's plane, in units: at least -kMaxDistanceBehind.
  double in_front = 0;
};

// The plane of a face. The normal points to the side from which the face is visible.
struct FacePlane {
  math::Vec3d normal;
  double distance;
};
FacePlane compute_face_plane(const Level& level, const Face& face);

// Returns the point of the face (a convex polygon with at least one vertex) that is nearest to `point`.
math::Vec3d find_nearest_point(const Level& level, const Face& face, const math::Vec3d& point);

// Finds faces of one model by position. Reuses its memory between queries.
class NearFaceFinder {
 public:
  // A point up to this far behind a face's plane, in units, still counts as in front, because network
  // messages round positions to 1/8 unit on each axis.
  static constexpr double kMaxDistanceBehind = 0.25;

  // Returns all faces of `model` that face `point` and are within `reach` units of it, in the tree's order.
  // Everything is in the model's space. The result is valid until the next call.
  std::span<const NearFace> find(const Level& level, ModelIndex model, const math::Vec3d& point,
                                 double reach);

 private:
  std::vector<Child> to_visit_;
  std::vector<NearFace> found_;
};

}  // namespace temblor::world
