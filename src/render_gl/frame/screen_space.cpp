#include "render_gl/frame/screen_space.h"

#include "render/color/blend_tables.h"

namespace temblor::render_gl {

math::Vec2 find_depth_scale(const render::ViewFrame& view) {
  // Units that depth covers in parallel projection, as in world_shaders.h.
  constexpr double kDepthRange = 262144;
  if (view.perspective) return {0, static_cast<float>(view.near_z)};
  return {static_cast<float>(1 + view.near_z / kDepthRange), static_cast<float>(1 / kDepthRange)};
}

ScreenProgram::ScreenProgram(const Functions& gl, Program program)
    : program_(std::move(program)),
      pixel_size_(gl.GetUniformLocation(program_.name(), "pixel_size")),
      depth_scale_(gl.GetUniformLocation(program_.name(), "depth_scale")),
      full_range_(gl.GetUniformLocation(program_.name(), "full_range")),
      perspective_(gl.GetUniformLocation(program_.name(), "perspective")),
      fog_density_(gl.GetUniformLocation(program_.name(), "fog_density")),
      fog_color_(gl.GetUniformLocation(program_.name(), "fog_color")),
      index_(gl, program_) {}

base::Result<ScreenProgram> ScreenProgram::make(const Functions& gl, const char* vertex_source,
                                                const char* fragment_source, ShaderLook look) {
  TRY(Program program, make_program(gl, (std::string(kScreenVertexPart) + vertex_source).c_str(),
                                    (look_part(look) + kScreenFragmentPart + fragment_source).c_str()));
  return ScreenProgram(gl, std::move(program));
}

void ScreenProgram::use(const Functions& gl, const render::ViewFrame& view, const render::Fog& fog,
                        const IndexTables* tables) const {
  gl.UseProgram(program_.name());
  gl.Uniform2f(pixel_size_, static_cast<float>(2.0 / view.width), static_cast<float>(2.0 / view.height));
  const math::Vec2 depth_scale = find_depth_scale(view);
  gl.Uniform2f(depth_scale_, depth_scale.x, depth_scale.y);
  gl.Uniform1i(full_range_, gl.ClipControl == nullptr);
  gl.Uniform1i(perspective_, view.perspective);
  const formats::Rgb color = render::to_bytes(fog.color);
  gl.Uniform1f(fog_density_, fog.density);
  gl.Uniform3f(fog_color_, static_cast<float>(color.b) / 255, static_cast<float>(color.g) / 255,
               static_cast<float>(color.r) / 255);
  if (tables != nullptr) tables->use_fog(gl, index_);
}

}  // namespace temblor::render_gl
