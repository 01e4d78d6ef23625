// A model and a sprite with some of everything: single frames and groups, single skins and groups, vertices
// on the seam, odd sides.
#pragma once

#include "formats/models/mdl.h"
#include "formats/models/spr.h"

namespace temblor::test {

// A tetrahedron of 4 vertices and 4 triangles; 7 x 3 texels; skins: one, a group of two; frames: one, a group
// of three.
formats::Mdl small_mdl();

// Frames: 3 x 2 texels, a group of two.
formats::Spr small_spr();

}  // namespace temblor::test
