// A frame's statistics as text for a person: what --stats prints.
#pragma once

#include <cstddef>
#include <string>

#include "render/frame.h"

namespace temblor::app {

// Several lines, each ended. `pixels`: of the frame, for cycles per pixel.
std::string describe_frame(const render::FrameStats& stats, std::size_t pixels);

}  // namespace temblor::app
