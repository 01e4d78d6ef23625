// Phong shading of the world: each pixel is lit by the level's light entities (Bui Tuong Phong, "Illumination
// for Computer Generated Pictures", 1975), by the cosine of the angle at which light arrives, without
// highlights.
//
// There are no shadows, so rooms are brighter than their light maps, and lights shine through walls. `lights`
// bounds the lights of a face. `smooth`: normals are averaged over the corners of neighboring faces. Dynamic
// lights shine too. A level without light entities, and parallel projection, are left to the engine.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_phong(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
