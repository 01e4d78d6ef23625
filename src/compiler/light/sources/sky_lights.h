// Light from the sky: suns, and the dome above (or below) the level, all as directions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/light/sources/settings.h"
#include "formats/levels/entities.h"
#include "math/vec.h"

namespace temblor::compiler {

// Parallel light that reaches a point where a ray towards it ends on sky.
struct SkyBeam {
  math::Vec3 towards_sky{0.0f};  // unit
  float value = 0;
  math::Vec3 color{1.0f};
  float angle_scale = 0.5f;
  std::uint8_t style = 0;
  bool takes_dirt = true;
};

// worldspawn's _sunlight, _sun2, _sunlight2 and _sunlight3, and those of light entities (_sun, _sunlight2,
// _sunlight3). A sun with a penumbra is several beams, a
// dome as many over its hemisphere: so many that each is about one step of the light map, but no more than
// `most_beams`.
std::vector<SkyBeam> sky_beams_of(std::span<const formats::Entity> entities, const LightSettings& settings,
                                  int most_beams);

}  // namespace temblor::compiler
