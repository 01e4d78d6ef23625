// A depth buffer for the world: each face's spans are tested pixel by pixel, and the parts that are nearer
// than everything before are drawn. (The engine fills its depth buffer without reading it.)
//
// The test runs first, and its results are spans: the engine's loops draw them. Parameter `order` 0 takes
// faces from front to back, so that most pixels fail the test; 1 from back to front, so that most pass.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_z_buffer(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
