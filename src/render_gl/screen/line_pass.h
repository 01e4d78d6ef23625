// Draws Scene::lines over the finished picture, in one draw call. A line becomes a parallelogram that is
// wider than a pixel. Its fragments find out which of them are the pixels of the CPU's line
// (render/screen/draw_lines.h).
#pragma once

#include <vector>

#include "render_gl/frame/screen_space.h"
#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

class LinePass {
 public:
  static base::Result<LinePass> make(const Functions& gl);

  // Needs the depth of everything opaque for lines with a depth test. Fails if the card lacks memory.
  base::Status draw(const Functions& gl, const FrameInput& input);

 private:
  // The layout is that of the shader.
  struct Corner {
    float x, y;
    float first, is_steep, is_tested;
    float across, across_slope, depth, depth_slope;  // at pixel `first`, and their growth from pixel to pixel
    std::uint32_t color;                             // 0xffRRGGBB, or an index
  };

  LinePass(const Functions& gl, ScreenProgram program);
  void add_line(const render::Line& line, const render::ViewFrame& view, std::uint32_t color);

  ScreenProgram program_;
  VertexArray vertex_array_;
  Buffer buffer_;
  std::vector<Corner> corners_;
};

}  // namespace temblor::render_gl
