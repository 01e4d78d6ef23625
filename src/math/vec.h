// The vectors of the whole program: GLM's, under our names. Map units unless said otherwise.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace temblor::math {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;

struct Bounds {
  Vec3 mins{0.0f}, maxs{0.0f};
};

}  // namespace temblor::math
