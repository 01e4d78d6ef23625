// Lines over the finished view: Scene::lines. They are one pixel wide, and those without a depth test are not
// hidden by anything.
#pragma once

#include <span>

#include "formats/images/palette.h"
#include "render/frame_buffer.h"
#include "render/scene.h"
#include "render/view/view_frame.h"

namespace temblor::render {

// Indexed frames show the nearest palette entry. Reads the frame's depth only for lines with a depth test.
void draw_lines(std::span<const Line> lines, const ViewFrame& view, const formats::Palette& palette,
                FrameBuffer& io_frame);

}  // namespace temblor::render
