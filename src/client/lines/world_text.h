// Text in the level, written with lines, for debugging.
#pragma once

#include <string>
#include <vector>

#include "math/vec.h"
#include "render/scene.h"

namespace temblor::client {

struct WorldText {
  std::string text;
  math::Vec3 origin_world{0.0f};  // the middle of the text
  float size = 8;                 // units, from the bottom to the top of a letter
  bool is_depth_tested = false;
};

// Appends the strokes of the letters, which face a camera with these angles. Small letters are written as
// capitals. Characters without a shape become boxes, spaces and control characters nothing.
void append_text_lines(const WorldText& text, const math::Vec3& camera_angles_deg,
                       std::vector<render::Line>& io_lines);

}  // namespace temblor::client
