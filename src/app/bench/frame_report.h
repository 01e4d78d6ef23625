// Formats a frame's statistics as text, for --stats.
#pragma once

#include <cstddef>
#include <string>

#include "render/frame_stats.h"

namespace temblor::app {

// Returns several lines, each with a newline. `pixels` is the size of the frame, for cycles per pixel.
std::string describe_frame(const render::FrameStats& stats, std::size_t pixels);

}  // namespace temblor::app
