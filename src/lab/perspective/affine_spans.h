// Texture coordinates that are exact at a few pixels of a span and linear in between. Parameter `pixels`: the
// distance of the exact ones; 16 is what stock Quake does.
//
// The engine's loops draw it, so only the distance differs.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_affine_spans(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
