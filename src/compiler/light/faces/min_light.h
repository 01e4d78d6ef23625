// Minimum light: that of the level and that of the brush, with the textures that have none, and its pattern.
#pragma once

#include <cstddef>
#include <vector>

#include "compiler/light/faces/face_light.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/sources/settings.h"
#include "math/vec.h"

namespace temblor::compiler {

// Raises the samples of style 0 of a light map to its minimum light: the greater of the level's and the
// brush's own, by channel. With _addmin, adds it instead. `light`: for the dirt of the map.
void add_min_light(const LitLevel& lit, const LightSettings& settings, std::size_t map,
                   const FaceLight& light, std::vector<math::Vec3>& io_samples);

// The factor of mottled minimum light at a place: spots about 32 units wide, 0.75 to 1.25, on average 1.
float find_mottle(const math::Vec3d& place_world);

}  // namespace temblor::compiler
