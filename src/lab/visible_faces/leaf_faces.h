// Front-face tests on leaves: every leaf that the walk reaches tests the faces that it borders. The engine
// tests the plane of each node once, for all faces in it. Here, faces in one plane are tested one by one, and
// the leaves before them in the list must be asked whether they tested a face already. (Quake's faces were
// stored on leaves before they were stored on nodes.)
//
// Faces get the engine's sort keys, so the picture is the same.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_leaf_faces(std::span<const double> values, Counter* counter);

// The planes that the engine tests against the eye while it finds `visible`.
std::uint64_t count_planes_tested(const render::FrameContext& context, const render::ViewFrame& view,
                                  const render::VisibleFaces& visible);

}  // namespace temblor::lab
