// The light at a point according to a level's light grid.
#pragma once

#include <optional>

#include "formats/levels/light_grid.h"
#include "math/vec.h"
#include "world/animation.h"
#include "world/sample_light.h"

namespace temblor::world {

// Interpolates linearly between the samples around the point that are in open space. Returns nothing if there
// is none, so also outside of the grid.
std::optional<PointLight> sample_light_grid(const formats::LightGrid& grid, const LightStyleValues& styles,
                                            const math::Vec3& point_world);

}  // namespace temblor::world
