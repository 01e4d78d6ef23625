// Which faces of the world lie near a point: for marks, and for whatever else has to do with a place on a
// wall.
#pragma once

#include <span>
#include <vector>

#include "world/level.h"

namespace temblor::world {

struct NearFace {
  FaceIndex face{};
  math::Vec3d nearest{0.0};  // the face's point that is nearest to the point asked for
  double distance = 0;       // between the two
  double in_front = 0;       // of the point asked for, before the face's plane; little below 0: behind it
};

// The plane of a face, its normal pointing to where the face is seen from.
struct FacePlane {
  math::Vec3d normal;
  double distance;
};
FacePlane plane_of(const Level& level, const Face& face);

// The point of a convex polygon that is nearest to `point`. The face has at least one vertex.
math::Vec3d nearest_point(const Level& level, const Face& face, const math::Vec3d& point);

// Looks faces of the world (model 0) up by place. Keeps its memory from one question to the next.
class FacesNear {
 public:
  // How far behind a face's plane a point still counts as before it: what rounding in messages (1/8 unit on
  // each axis) can do to a point on the face.
  static constexpr double kBehind = 0.25;

  // All faces that turn their front to `point` and come within `reach` units of it, in the tree's order.
  // Valid until the next question.
  std::span<const NearFace> find(const Level& level, const math::Vec3d& point, double reach);

 private:
  std::vector<Child> to_visit_;
  std::vector<NearFace> found_;
};

}  // namespace temblor::world
