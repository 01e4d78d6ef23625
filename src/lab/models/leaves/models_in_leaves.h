// Models without a depth buffer, by the painter's algorithm: their triangles are cut at the planes of the BSP
// tree, and each leaf's parts are painted when the world, from back to front, has come to that leaf.
//
//   faces behind the leaf, parts in the leaf, faces before the leaf, ...
//
// Within a leaf, farther models come first, and within a model, farther triangles. So these are wrong:
//   triangles of one leaf that no order of their middles is right for, of one model or of two that touch;
//   a door's face in the same leaf as a model: the model is always painted over it;
//   without cuts, parts in other leaves than the model's middle.
//
// Parameter `cut`: 1: cuts triangles; 0: paints a whole model in the leaf of its middle.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_models_in_leaves(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
