// Each vertex of a model as a box of 2x2 pixels, without triangles: the boxes together form the model's
// shape, and gaps show where triangles are large. All vertices are drawn, on whichever side they are. Of
// models that reach behind the eye, only those of triangles in front of it are.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_vertex_boxes(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
