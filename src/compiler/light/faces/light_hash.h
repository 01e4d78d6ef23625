// Hashes that tell whether two runs light the same level by the same lights.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "compiler/light/light_level.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"

namespace temblor::compiler {

// Returns the level without its light and without all lumps that describe light.
formats::Bsp strip_light(const formats::Bsp& bsp);

// A hash of everything that a level's light depends on.
std::uint64_t hash_light_input(const formats::Bsp& unlit_bsp, const FaceKeys& face_keys,
                               const LightOptions& options);

// A hash of what rays meet and of the sample points: the level without its entities, except for where its
// models are. 0: the level is too large for a file, and so for a cache.
std::uint64_t hash_geometry(formats::Bsp unlit_bsp, const LitLevel& lit, const LightOptions& options);
// A hash of the dirt settings.
std::uint64_t hash_dirt(const DirtSettings& settings);
// A hash of the sky's light before dirt, and of whether its directions are kept.
std::uint64_t hash_sky(std::span<const SkyBeam> beams, const LightSettings& settings);

}  // namespace temblor::compiler
