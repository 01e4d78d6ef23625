// A level so small that a test can damage every byte: one room, [-64, 64] on each axis, with lit walls.
#pragma once

#include "formats/levels/bsp.h"

namespace temblor::test {

// Leaf 1 is the room. Walls come in the order +x -x +y -y +z -z: wall i is plane i, node i, face i, and
// clipnode i of hull 1. Model 1 is one node (number 6) without faces. Textures: 0 "wall" 16 x 16, 1 not
// present, 2 "outside" 32 x 16 without texels. No BSPX.
formats::Bsp make_cube_room();

// The same room as a file of a version. CHECKs that it can be written.
base::ByteVector make_cube_room_file(formats::BspVersion version);

}  // namespace temblor::test
