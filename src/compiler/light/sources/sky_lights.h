// Light from the sky as a set of parallel beams: suns, and the domes above and below the level.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "compiler/light/sources/settings.h"
#include "compiler/report.h"
#include "formats/levels/entities.h"
#include "math/vec.h"
#include "world/level.h"

namespace temblor::compiler {

// Parallel light. It reaches a point if a ray toward it ends on sky.
struct SkyBeam {
  math::Vec3 toward_sky{0.0f};  // of length 1
  float value = 0;
  math::Vec3 color{1.0f};
  float angle_scale = 0.5f;
  std::uint8_t style = 0;
  bool takes_dirt = true;
  std::optional<std::uint32_t> sky_name;  // _suntexture: comes only from skies with this texture's number
};

// Reads worldspawn's _sunlight, _sun2, _sunlight2 and _sunlight3, and the light entities with _sun,
// _sunlight2 or _sunlight3. A sun with a penumbra becomes several beams, a dome as many over its hemisphere:
// so many that each is about one step of the light map, but at most `max_beams`.
// `level`: has the textures that _suntexture names; a sun whose texture the level lacks does not shine.
std::vector<SkyBeam> find_sky_beams(std::span<const formats::Entity> entities, const LightSettings& settings,
                                    int max_beams, const world::Level& level, Warnings& io_warnings);

}  // namespace temblor::compiler
