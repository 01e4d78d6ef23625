// The painter's algorithm: whole faces from back to front, each over those before it. Nothing is sorted on
// the screen, but hidden surfaces are built and drawn, too.
//
// Parameter `pvs` 0 draws everything in the frustum, as without the potentially visible set.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_painter(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
