// Models as streams of commands for a small stack of vertices (command_stream.h), which should stay in the
// first-level cache. No list of a model's transformed vertices is written; vertices that leave the stack too
// early, and those of models in several bands of the picture, are transformed again.
//
// Pixels are those of the engine's scan lines. Only where triangles have equal depths, their order shows.
// Models that reach behind the eye are drawn by the engine.
//
// Parameters: `stack`: places of the stack. `group`: pushes that are transformed together, and whose
// triangles are set up together, rounded up to a multiple of 16; 0: one command after another.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_stack_meshes(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
