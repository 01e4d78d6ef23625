// Places and turns of a model's bones. x is ahead, y left, z up.
#pragma once

#include <glm/mat3x3.hpp>

#include "math/vec.h"

namespace temblor::artgen {

struct Transform {
  glm::dmat3 linear{1.0};
  math::Vec3d offset{0.0};

  math::Vec3d operator()(const math::Vec3d& place) const { return linear * place + offset; }
  Transform operator*(const Transform& inner) const {
    return {linear * inner.linear, linear * inner.offset + offset};
  }
};

// Pitch leans what points up ahead, yaw turns what points ahead to the left, roll leans what points up to the
// right; roll first.
glm::dmat3 rotation(const math::Vec3d& pitch_yaw_roll_deg);

}  // namespace temblor::artgen
