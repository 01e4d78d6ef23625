// Small triangles by precalculated masks: with corners at whole pixels, the pixels of a small triangle are
// looked up, and no edge is followed. Larger triangles are drawn by the engine's scan lines, also with
// corners at whole pixels and affine texels, so the picture is that of affine-models:subpixel=0.
//
// Parameter `side`: triangles up to so many pixels high and wide have masks.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_triangle_masks(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
