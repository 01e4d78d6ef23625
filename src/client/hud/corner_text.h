// Small readouts over the picture, such as the frame rate.
#pragma once

#include <string_view>

#include "assets/pictures.h"
#include "render/draw_list.h"

namespace temblor::client {

// Draws text right-aligned in the upper right corner of a frame of `width` x `height` pixels, `line` lines
// below the top. `text_size`: HudSize::text. Appends to `io_list`; the commands are valid while the pictures
// live.
void draw_corner_text(const assets::Pictures& pictures, std::string_view text, int line, float text_size,
                      int width, int height, render::DrawList& io_list);

}  // namespace temblor::client
