// Reads the depth of each pixel from the card, for the debug view that shows it. OpenGL ES cannot copy depth
// to the CPU, so a pass over the picture writes the bits of each number into the channels of a color.
#pragma once

#include <span>

#include "render/view/view_frame.h"
#include "render_gl/frame/target.h"

namespace temblor::render_gl {

class DepthReader {
 public:
  static base::Result<DepthReader> make(const Functions& gl);

  // Waits for the card and copies the depth of all pixels as the CPU keeps it: 1/z, or -z in a parallel
  // projection; times kWeaponDepthScale for the view weapon; the lowest float where nothing was drawn.
  // `out_depth` holds width * height numbers. Fails if the card lacks memory.
  base::Status read(const Functions& gl, const render::ViewFrame& view, const Target& target,
                    std::span<float> out_depth) const;

 private:
  DepthReader(const Functions& gl, Program program);

  Program program_;
  GLint depth_, depth_scale_, weapon_scale_;
  VertexArray no_vertices_;
};

}  // namespace temblor::render_gl
