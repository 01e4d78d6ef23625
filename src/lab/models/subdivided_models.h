// Models by recursive subdivision only, at all distances, as the engine draws small ones
// (render/alias/subdivide_triangles.cpp).
//
// The engine's subdivision does not clip. Models that reach out of the screen are drawn by a version that
// leaves out parts of triangles outside of it, and draws huge triangles by scan lines (split_triangles.h).
//
// Parameter `light`: 0: each triangle has the light of its first vertex; 1: light is halved with the sides,
// like texels.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_subdivided_models(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
