// Affine transforms for bones and shapes of a model. x is forward, y left, z up, in map units.
#pragma once

#include <glm/mat3x3.hpp>

#include "math/vec.h"

namespace temblor::artgen {

// Maps a point p to linear * p + offset. transform(p) applies it.
struct Transform {
  glm::dmat3 linear{1.0};
  math::Vec3d offset{0.0};

  math::Vec3d operator()(const math::Vec3d& position) const { return linear * position + offset; }
  // The transform that applies `inner` first.
  Transform operator*(const Transform& inner) const {
    return {linear * inner.linear, linear * inner.offset + offset};
  }
};

// For a bone that points up, pitch leans it forward and roll leans it to the right; yaw turns it to the left.
// Roll is applied first, then pitch, then yaw.
glm::dmat3 make_rotation(const math::Vec3d& pitch_yaw_roll_deg);

}  // namespace temblor::artgen
