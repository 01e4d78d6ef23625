// Texture and light in one pass, without surfaces: each pixel looks up its texel and the light map.
//
// Texels and light have the arithmetic of surface blocks, so the picture is the engine's, except for what
// lit_draws.h leaves out. Parameter `bilinear`: 1: interpolates between four samples; 0: the nearest sample.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_one_pass(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
