#include "render_gl/world/face_view.h"

#include <cmath>

#include "render/color/warped_rows.h"

namespace temblor::render_gl {

namespace {

std::array<float, 9> columns(const math::Vec3d& x, const math::Vec3d& y, const math::Vec3d& z) {
  const math::Vec3 a(x), b(y), c(z);
  return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

void set_view(const Functions& gl, const render::ViewFrame& view, const FaceProgram& program) {
  const math::Vec3 eye(view.eye_world);
  gl.Uniform3f(program.eye, eye.x, eye.y, eye.z);
  const std::array<float, 9> axes = columns(view.axes.right, view.axes.up, view.axes.forward);
  gl.UniformMatrix3fv(program.view_axes, 1, GL_TRUE, axes.data());
  gl.Uniform4f(program.projection, static_cast<float>(2 * view.pixels_per_unit / view.width),
               static_cast<float>(2 * view.pixels_per_unit / view.height), static_cast<float>(view.near_z),
               view.perspective ? 1.0f : 0.0f);
  gl.Uniform1i(program.full_range, gl.ClipControl == nullptr);
}

void set_time(const Functions& gl, double time_s, const FaceProgram& program) {
  gl.Uniform1f(program.liquid_phase, static_cast<float>(render::compute_turbulence_phase(time_s)));
  // Stock Quake's speeds. After 64 layers, every layer is where it began.
  constexpr double kPeriod_texels = 128 * 64, kClouds_texels_s = 16, kBackground_texels_s = 8;
  gl.Uniform2f(program.sky_scroll, static_cast<float>(std::fmod(time_s * kClouds_texels_s, kPeriod_texels)),
               static_cast<float>(std::fmod(time_s * kBackground_texels_s, kPeriod_texels)));
}

void set_fog(const Functions& gl, const render::Fog& fog, const FaceProgram& program) {
  const formats::Rgb color = render::to_bytes(fog.color);
  gl.Uniform1f(program.fog_density, fog.density);
  gl.Uniform3f(program.fog_color, static_cast<float>(color.b) / 255, static_cast<float>(color.g) / 255,
               static_cast<float>(color.r) / 255);
}

}  // namespace

void use_face_program(const Functions& gl, const FrameInput& input, const FaceProgram& program,
                      bool has_color_key) {
  gl.UseProgram(program.program.name());
  gl.Uniform1i(program.has_color_key, has_color_key);
  set_view(gl, input.record.view, program);
  set_time(gl, input.scene().time_s, program);
  set_fog(gl, input.scene().fog, program);
  if (input.index_tables != nullptr) input.index_tables->use_fog(gl, program.index);
}

void set_face_instance(const Functions& gl, const FrameInput& input, const FaceProgram& program,
                       std::uint32_t instance) {
  const render::ModelView& model = input.record.edges.model_views[instance];
  const std::array<float, 9> axes = columns(model.x_axis, model.y_axis, model.z_axis);
  const math::Vec3 origin(model.origin_world);
  gl.UniformMatrix3fv(program.model_axes, 1, GL_FALSE, axes.data());
  gl.Uniform3f(program.model_origin, origin.x, origin.y, origin.z);
  gl.Uniform1f(program.nearer, instance > 0 ? kBrushModelNearer : 0);
}

}  // namespace temblor::render_gl
