// Faces that shine: every face with the texture of a light's _surface key carries copies of that light.
#pragma once

#include <span>
#include <vector>

#include "compiler/light/lit_level.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/light_source.h"

namespace temblor::compiler {

// A copy in the middle of each piece of a face, cut into pieces at most 128 units wide.
std::vector<LightSource> surface_lights_of(const LitLevel& lit, std::span<const SurfaceTemplate> templates);

}  // namespace temblor::compiler
