// Models by scan lines only, at all distances, with the engine's kernels.
//
// Parameter `subpixel`: 1: vertices lie at multiples of 1/256 pixel; 0: at whole pixels, as in stock Quake.
// Parameter `perspective`: 0: texels are linear on the screen, 1: divided by depth at each pixel. The engine
// divides where affine texels would be off by half a texel.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_affine_models(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
