// Texture coordinates along lines of equal z, where they are linear, so that no pixel needs a division. Each
// surface gets a table with the distance of each of its lines, and pixels between two lines interpolate
// (z_line_kernels.h). Spans that are too short for a table, or would be too far off, are drawn by the engine.
//
// Parameter `texels`: the largest error.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_equal_z_spans(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
