// The end of a frame: the underwater warp and the tint, in one pass over the picture. Both are exactly those
// of the CPU (render/screen): the CPU computes where pixels come from, and colors are blended in whole
// numbers.
#pragma once

#include "render/scene.h"
#include "render/screen/tint_picture.h"
#include "render/screen/warp.h"
#include "render_gl/frame/target.h"

namespace temblor::render_gl {

class FinishPass {
 public:
  static base::Result<FinishPass> make(const Functions& gl);

  // Warps and tints what was drawn into the target. Indexed frames are tinted when
  // they are shown. Does nothing for a scene without either. Fails if the
  // card lacks memory.
  base::Status draw(const Functions& gl, const render::Scene& scene, Target& io_target);

 private:
  FinishPass(const Functions& gl, Program program);
  base::Status load_sources(const Functions& gl, const Target& target, double time_s);

  Program program_;
  GLint picture_, warp_sources_, is_warped_, tint_;
  VertexArray no_vertices_;
  render::WarpSources sources_;
  Texture source_texture_;  // the columns' row, and the rows' row
  int source_size_ = 0;
};

}  // namespace temblor::render_gl
