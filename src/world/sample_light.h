// Samples the light at a point, to light entities. A level may have a grid of light for this
// (formats/levels/light_grid.h). In most, the light compiler only lights faces, so the floor below counts.
//
// Method for the floor: walk a vertical line through the world's tree, near side first. At each plane that
// the line crosses, look for a face of that node that contains the crossing point; the first one found is the
// nearest. The original samples light by the same rule, but takes the nearest light sample instead of
// interpolating.
#pragma once

#include "math/vec.h"
#include "world/animation.h"
#include "world/level.h"

namespace temblor::world {

// Light levels: 0 to 255 as in the light map; more if a light style is brighter than normal.
struct PointLight {
  float gray = 0;
  math::Vec3 rgb{0.0f};  // equals gray if the level has no colored light
  bool operator==(const PointLight&) const = default;
};

// Takes the light from the level's grid if it has any at the point. Otherwise, follows a line from
// `point_world` 2048 units straight down to the first face of the world, and interpolates between that face's
// light samples. Skips sky, liquids, and faces that are never lit. A face without samples is dark, and so is
// a point without a face below. Everything is 255 in a level that was never lit. Ignores brush models, as the
// original does.
PointLight sample_light(const Level& level, const LightStyleValues& styles, const math::Vec3& point_world);

}  // namespace temblor::world
