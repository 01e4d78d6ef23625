// Surfaces whose light always changes: blocks that the cache has are built again. Parameter `every`: each
// frame builds one of so many blocks, in turns, so 1 builds all, and 2 half of them (Abrash, "Quake's
// Lighting Model: Surface Caching", "Two final notes on surface caching").
//
// The light stays as it is, so the picture is the engine's.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_rebuilt_surfaces(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
