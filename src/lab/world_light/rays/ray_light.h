// Light of each pixel by rays: the level's lights, suns, sky domes, and glowing surfaces shine where Embree
// finds nothing between them and the pixel. Light falls off and depends on the angle as in phong.h.
//
// Only direct light, and at least the level's minimum: no light from other walls. Brush models get shadows
// but cast none, like those of most levels' light maps. Dynamic lights cast shadows, too.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_ray_light(std::span<const double> values, Counter* counter);

// An error of one line if the level has no light entities, or if there is no Embree.
base::Status check_ray_light(std::span<const double> values, const world::Level& level);

}  // namespace temblor::lab
