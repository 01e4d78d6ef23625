// Small measurements over the picture.
#pragma once

#include <string_view>

#include "assets/pictures.h"
#include "render/draw_list.h"

namespace temblor::client {

// In the frame's upper right corner, `line` lines below its edge.
void draw_corner_text(const assets::Pictures& pictures, std::string_view text, int line, int width,
                      int height, render::DrawList& io_list);

}  // namespace temblor::client
