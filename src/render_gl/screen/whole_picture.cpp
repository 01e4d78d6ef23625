#include "render_gl/screen/whole_picture.h"

namespace temblor::render_gl {

void draw_whole_picture(const Functions& gl, const VertexArray& no_vertices) {
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_DEPTH_TEST);
  gl.BindVertexArray(no_vertices.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BindVertexArray(0);
  gl.Enable(GL_DEPTH_TEST);
}

}  // namespace temblor::render_gl
