// Surface lights: every face with the texture that a light's _surface names gets copies of that light.
#pragma once

#include <span>
#include <vector>

#include "compiler/light/lit_level.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/light_source.h"

namespace temblor::compiler {

// Cuts each such face along the world's grid of 128 units, and places a copy at the center of each piece.
std::vector<LightSource> find_surface_lights(const LitLevel& lit, std::span<const SurfaceTemplate> templates);

}  // namespace temblor::compiler
