// Passes over a whole picture: their vertex shader, and the draw call.
#pragma once

#include "render_gl/gl/objects.h"

namespace temblor::render_gl {

// One triangle that covers the picture: draw three vertices, without a buffer.
inline constexpr const char* kWholePictureShader = R"(
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
)";

// Draws the triangle with the program in use: every pixel, whatever its depth. `no_vertices` has no buffers.
void draw_whole_picture(const Functions& gl, const VertexArray& no_vertices);

}  // namespace temblor::render_gl
