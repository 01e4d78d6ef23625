// The picture of each model, kept for some frames and drawn where the model has moved to.
//
//   frame 0   triangles -> picture -> frame        frame 1   picture, moved -> frame
//
// The picture keeps its size, and its depth follows the model's middle. In each frame, an equal share of the
// models gets new pictures. Models that may reach behind the eye, huge ones, and the view model are drawn as
// triangles.
// The number in the scene identifies a model.
//
// Parameter `frames`: frames that a picture is used for; 1: only the one that it was made in.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_model_sprites(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
