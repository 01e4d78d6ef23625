#include "render_gl/models/alias_layer.h"

#include "render_gl/models/alias_shaders.h"

namespace temblor::render_gl {

AliasLayer::AliasLayer(const Functions& gl, Program program)
    : program_(std::move(program)),
      colors_(gl.GetUniformLocation(program_.name(), "colors")),
      depths_(gl.GetUniformLocation(program_.name(), "depths")),
      opacity_(gl.GetUniformLocation(program_.name(), "opacity")),
      no_vertices_(make_vertex_array(gl)) {}

base::Result<AliasLayer> AliasLayer::make(const Functions& gl) {
  TRY(Program program, make_program(gl, kLayerVertexShader, kLayerFragmentShader));
  return AliasLayer(gl, std::move(program));
}

base::Status AliasLayer::begin(const Functions& gl, const Target& target, const PixelRect& rect) {
  if (picture_.width() != target.width() || picture_.height() != target.height()) {
    TRY(picture_, Target::make(gl, target.width(), target.height()));
  }
  picture_.bind(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(rect.x, rect.y, rect.width, rect.height);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return base::Ok{};
}

void AliasLayer::end(const Functions& gl, const Target& target, float opacity) const {
  target.bind(gl);
  gl.UseProgram(program_.name());
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, picture_.color_texture());
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, picture_.depth_texture());
  gl.Uniform1i(colors_, 0);
  gl.Uniform1i(depths_, 1);
  gl.Uniform1f(opacity_, opacity);
  gl.Enable(GL_BLEND);
  // The picture's alpha stays 1.
  gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  gl.DepthMask(GL_FALSE);
  gl.DepthFunc(GL_GEQUAL);
  gl.DepthRangef(0, 1);
  gl.BindVertexArray(no_vertices_.name());
  gl.DrawArrays(GL_TRIANGLES, 0, 3);
  gl.BindVertexArray(0);
  gl.DepthRangef(0, kWorldDepthEnd);
  gl.DepthFunc(GL_GREATER);
  gl.DepthMask(GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_SCISSOR_TEST);
}

}  // namespace temblor::render_gl
