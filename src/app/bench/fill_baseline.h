// The fill baseline: a scalar loop that fills a frame from one texture, the least work that a frame of
// textured pixels can take. Frame times divided by its time depend little on the machine, so goals can be
// stated for all machines.
#pragma once

#include "render/frame_buffer.h"

namespace temblor::app {

// Fills the frame's pixels, not its depth, from one 256 x 256 surface. Texture coordinates are 16.16 fixed
// point and step by s += 40000, t += 3000 per pixel; each pixel is one texel read and one store. Compiled
// without vectorization.
//
// The offset of such a short loop in a cache line of code changes its time by a factor of up to 1.8 (measured
// on a Zen 5) and varies with every build. The program therefore has several copies, 16 bytes apart, and uses
// the fastest:
//
//   64-byte line   | 0    16   32   48 |
//   copy           | 0    1    2    3  |
constexpr int kBaselinePlacements = 4;
void run_fill_baseline(int placement, render::FrameBuffer& io_frame);
// Times all copies and returns the fastest, for run_fill_baseline().
int find_fastest_placement(render::FrameBuffer& io_frame);

}  // namespace temblor::app
