// The vertex shader of passes over a whole picture.
#pragma once

namespace temblor::render_gl {

// One triangle that covers the picture: draw three vertices, without a buffer.
inline constexpr const char* kWholePictureShader = R"(
void main() {
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
)";

}  // namespace temblor::render_gl
