// Translucent marks on every face, which are painted when its surface is built (Abrash, "Quake's Lighting
// Model: Surface Caching", "Two final notes on surface caching"). Parameter `marks`: how many each face gets.
// Faces with marks of their own keep those.
#pragma once

#include "lab/technique.h"

namespace temblor::lab {

render::FrameStages make_marked_surfaces(std::span<const double> values, Counter* counter);

}  // namespace temblor::lab
