// How brightly the floor below a point is lit: what things that are not part of the level are lit by.
#pragma once

#include "math/vec.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::world {

// 0 to 255 as in the light map, more where a style is brighter than normal.
struct PointLight {
  float gray = 0;
  math::Vec3 rgb{0.0f};  // equal to gray where the level has no colored light
  bool operator==(const PointLight&) const = default;
};

// The light map of the world's first face that a line from `point_world`, 2048 units straight down, crosses,
// interpolated between its samples. Sky, liquids and faces that are never lit are passed over; a face without
// samples is dark. Nothing below is dark as well; everything is at 255 in a level that was never lit. Brush
// models are not looked at, as in the original.
PointLight light_at(const Level& level, const LightStyleValues& styles, const math::Vec3& point_world);

}  // namespace temblor::world
