// Draws particles: the squares that the CPU places and cuts (render/particles), in one draw call.
#pragma once

#include <vector>

#include "render/particles/draw_particles.h"
#include "render_gl/frame/screen_space.h"
#include "render_gl/world/world_pass.h"

namespace temblor::render_gl {

class ParticlePass {
 public:
  static base::Result<ParticlePass> make(const Functions& gl, render::PixelFormat format);

  // Draws the scene's particles, with depth, over everything opaque. Fails if the card lacks memory.
  base::Status draw(const Functions& gl, const FrameInput& input);

 private:
  ParticlePass(const Functions& gl, ScreenProgram program);

  ScreenProgram program_;
  VertexArray vertex_array_;
  Buffer buffer_;
  std::vector<render::ParticleRect> rects_;
};

}  // namespace temblor::render_gl
