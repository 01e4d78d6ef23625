// The floor that frame times are measured against: the least work that puts a textured pixel on the screen.
#pragma once

#include "render/frame.h"

namespace temblor::app {

// Fills the frame's pixels (not its depth) from one 256 x 256 surface with the plain scalar loop that anyone
// would write: per row, texture coordinates in 16.16 that step by s += 40000, t += 3000 a pixel; one texel
// read and one store for each. Compiled without vectorization.
//
// Where such a short loop begins within a cache line of code changes its time by up to 1.8 (measured on a
// Zen 5), and would change with every build. So it is there in several places, 16 bytes from one to the next,
// and the quickest is the floor.
constexpr int kFloorPlacements = 4;
void fill_with_floor_loop(int placement, render::FrameBuffer& io_frame);
int quickest_floor_placement(render::FrameBuffer& io_frame);

}  // namespace temblor::app
