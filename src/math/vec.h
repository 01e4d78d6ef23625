// Vector types of the whole program, from GLM. Coordinates are in map units unless documented otherwise.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace temblor::math {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec2d = glm::dvec2;
using Vec3d = glm::dvec3;

// An axis-aligned box. Empty boxes have no special value.
struct Bounds {
  Vec3 mins{0.0f}, maxs{0.0f};
};

}  // namespace temblor::math
