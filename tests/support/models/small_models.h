// A model and a sprite with all features: single frames and groups, single skins and groups, vertices on the
// seam, odd sides.
#pragma once

#include "formats/models/mdl.h"
#include "formats/models/spr.h"

namespace temblor::test {

// A tetrahedron with 4 vertices and 4 triangles, and 7 x 3 texels. Skins: a single one and a group of two.
// Frames: a single one and a group of three.
formats::Mdl small_mdl();

// Frames: a single one of 3 x 2 texels, and a group of two.
formats::Spr small_spr();

}  // namespace temblor::test
