// Blends translucent models into the picture, as the CPU does: a model is drawn alone, as if opaque, into a
// picture of its own, and then each of its pixels that is in front is blended once. So hidden parts of the
// model do not show through its front, and the depth of the picture stays.
#pragma once

#include "render_gl/world/frame_input.h"

namespace temblor::render_gl {

class AliasLayer {
 public:
  static base::Result<AliasLayer> make(const Functions& gl, render::PixelFormat format);

  // Until end(), drawing goes to a clear picture of the target's size, inside `rect` only. Fails if the card
  // lacks memory for that picture.
  base::Status begin(const Functions& gl, const Target& target, const PixelRect& rect);
  // Blends what was drawn since begin() into the target, which is drawn to from then on. `alpha`: 0 to 1.
  // Fails if the card lacks memory.
  base::Status end(const Functions& gl, const FrameInput& input, float alpha, Target& io_target) const;

 private:
  AliasLayer(const Functions& gl, Program program);

  Program program_;
  GLint colors_, depths_, opacity_;
  IndexUniforms index_;
  VertexArray no_vertices_;
  Target picture_;
  PixelRect rect_{};
};

}  // namespace temblor::render_gl
