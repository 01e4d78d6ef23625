#include "render_gl/models/alias_layer.h"

#include "render/color/blend_tables.h"
#include "render_gl/gl/shader_look.h"
#include "render_gl/models/alias_shaders.h"

namespace temblor::render_gl {

AliasLayer::AliasLayer(const Functions& gl, Program program)
    : program_(std::move(program)),
      colors_(gl.GetUniformLocation(program_.name(), "colors")),
      depths_(gl.GetUniformLocation(program_.name(), "depths")),
      opacity_(gl.GetUniformLocation(program_.name(), "opacity")),
      index_(gl, program_),
      no_vertices_(make_vertex_array(gl)) {}

base::Result<AliasLayer> AliasLayer::make(const Functions& gl, render::PixelFormat format) {
  const bool is_indexed = format == render::PixelFormat::kIndexed;
  const ShaderLook look = is_indexed ? ShaderLook::kBlendedIndices : ShaderLook::kColors;
  TRY(Program program,
      make_program(gl, kLayerVertexShader, (look_part(look) + kLayerFragmentShader).c_str()));
  return AliasLayer(gl, std::move(program));
}

base::Status AliasLayer::begin(const Functions& gl, const Target& target, const PixelRect& rect) {
  if (!picture_.has_layout(target.width(), target.height(), target.format())) {
    TRY(picture_, Target::make(gl, target.width(), target.height(), target.format()));
  }
  rect_ = rect;
  picture_.bind(gl);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(rect.x, rect.y, rect.width, rect.height);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return base::Ok{};
}

base::Status AliasLayer::end(const Functions& gl, const FrameInput& input, float alpha,
                             Target& io_target) const {
  io_target.bind(gl);
  gl.UseProgram(program_.name());
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindTexture(GL_TEXTURE_2D, picture_.color_texture());
  gl.ActiveTexture(GL_TEXTURE1);
  gl.BindTexture(GL_TEXTURE_2D, picture_.depth_texture());
  gl.Uniform1i(colors_, 0);
  gl.Uniform1i(depths_, 1);
  gl.Uniform1f(opacity_, static_cast<float>(render::opacity_256(alpha)) / float{render::kOpaque256});
  if (input.index_tables != nullptr) {
    const IndexBlend blend{.table = input.context.colors.blends.table_for(alpha)};
    TRY_STATUS(input.index_tables->use_blend(gl, index_, blend, rect_, io_target));
  } else {
    gl.Enable(GL_BLEND);
  }
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
  return base::Ok{};
}

}  // namespace temblor::render_gl
