#include "compiler/light/faces/face_frame.h"

#include <cmath>

namespace temblor::compiler {
namespace {

// Returns the part of an axis that is perpendicular to the normal, with length 1. If there is none, any
// perpendicular direction.
math::Vec3d make_perpendicular(const math::Vec3d& axis, const math::Vec3d& normal) {
  constexpr double kNone = 1e-6;
  math::Vec3d across = axis - normal * glm::dot(axis, normal);
  if (glm::length(across) <= kNone * glm::length(axis) || glm::length(axis) == 0)
    across = glm::cross(normal, std::abs(normal.z) < 0.9 ? math::Vec3d(0, 0, 1) : math::Vec3d(1, 0, 0));
  return glm::normalize(across);
}

}  // namespace

FaceFrame make_face_frame(const world::TextureAxes& axes, const math::Vec3d& normal) {
  return {make_perpendicular(math::Vec3d(axes.s_axis), normal),
          make_perpendicular(math::Vec3d(axes.t_axis), normal), normal};
}

}  // namespace temblor::compiler
