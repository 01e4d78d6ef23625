// Tells whether two runs light the same level, by the same lights.
#pragma once

#include <cstdint>
#include <span>

#include "base/bytes.h"
#include "compiler/light/light_level.h"
#include "compiler/light/lit_level.h"
#include "compiler/light/sources/settings.h"
#include "compiler/light/sources/sky_lights.h"

namespace temblor::compiler {

// The level that light falls on: as it is, but for light and what follows from it.
formats::Bsp unlit(const formats::Bsp& bsp);

std::uint64_t hash_of_light_input(const formats::Bsp& unlit, const FaceKeys& face_keys,
                                  const LightOptions& options);

// Of all that rays meet and of where light is measured: the level without its entities but for where its
// models stand. 0: the level is too large for a file, and so for a cache.
std::uint64_t hash_of_geometry(formats::Bsp unlit, const LitLevel& lit, const LightOptions& options);
std::uint64_t hash_of_dirt(const DirtSettings& settings);
// Of what is added up for the sky, but for dirt. `range`: LightSettings's.
std::uint64_t hash_of_sky(std::span<const SkyBeam> beams, float range);

}  // namespace temblor::compiler
