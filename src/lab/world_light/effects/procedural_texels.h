// Procedural texels: a pattern is computed onto each surface when it is built, and the surface cache keeps
// the result (Abrash, "Quake's Lighting Model: Surface Caching", "Two final notes on surface caching").
// Parameter `pattern`: 0 is noise on all faces, built once; 1 is water that runs down walls; 2 is fire on
// walls. Both move, so all surfaces in view are built again in each frame, or one of `every`, in turns.
//
// Light comes first, so fire glows in the dark.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_procedural_texels(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
