#include "render_gl/models/alias_pass.h"

#include <string>

#include "render/alias/draw_alias_models.h"
#include "render/alias/prepare_alias.h"
#include "render_gl/gl/projection.h"
#include "render_gl/gl/shader_look.h"
#include "render_gl/models/alias_shaders.h"

namespace temblor::render_gl {

namespace {

constexpr GLint kSkinsUnit = 0, kPalettesUnit = 1, kColormapUnit = 2, kTintsUnit = 3;

bool is_weapon(const render::AliasPlacement& placement) {
  return placement.depth_scale == render::kWeaponDepthScale;
}

}  // namespace

AliasPass::AliasPass(const Functions& gl, Program program, PlayerPalettes palettes, AliasLayer layer)
    : index_(gl, program), palettes_(std::move(palettes)), layer_(std::move(layer)) {
  set_program(gl, std::move(program));
}

void AliasPass::set_program(const Functions& gl, Program program) {
  program_ = std::move(program);
  index_ = IndexUniforms(gl, program_);
  const auto find = [&](const char* name) { return gl.GetUniformLocation(program_.name(), name); };
  uniforms_ = {find("to_view"),    find("pose_blend"), find("lights"),      find("projection"),
               find("full_range"), find("skins"),      find("palettes"),    find("skin"),
               find("palette"),    find("tint"),       find("fog_density"), find("fog_color"),
               find("colormap"),   find("tints"),      find("tint_row")};
}

namespace {

base::Result<Program> make_alias_program(const Functions& gl, render::PixelFormat format,
                                         const TexelBlend& blend) {
  const std::string vertex = std::string(kProjectionPart) + kAliasVertexShader;
  const std::string fragment = texel_blend_defines(blend) + look_part(find_look(format)) + kAliasTexelPart +
                               kTexelBlendPart + kAliasFragmentShader;
  return make_program(gl, vertex.c_str(), fragment.c_str());
}

}  // namespace

base::Result<AliasPass> AliasPass::make(const Functions& gl, const render::ColorTables& colors,
                                        render::PixelFormat format) {
  TRY(Program program, make_alias_program(gl, format, {}));
  TRY(PlayerPalettes palettes, PlayerPalettes::make(gl, colors, format));
  TRY(AliasLayer layer, AliasLayer::make(gl, format));
  return AliasPass(gl, std::move(program), std::move(palettes), std::move(layer));
}

base::Status AliasPass::set_blend(const Functions& gl, const FrameInput& input) {
  const TexelBlend wanted = find_texel_blend(input.options);
  if (wanted == blend_) return base::Ok{};
  TRY(Program program, make_alias_program(gl, input.context.format, wanted));
  set_program(gl, std::move(program));
  blend_ = wanted;
  return base::Ok{};
}

base::Status AliasPass::draw_opaque(const Functions& gl, const FrameInput& input) {
  models_.begin_frame();
  instances_drawn_ = triangles_drawn_ = 0;
  TRY_STATUS(set_blend(gl, input));
  if (!input.sources.fill_depth) return base::Ok{};
  const std::span<const render::AliasPlacement> placements =
      render::place_alias_models(input.scene(), input.record.view, input.context.arena());
  if (placements.empty()) return base::Ok{};
  begin_draw(gl, input);
  for (const render::AliasPlacement& placement : placements) {
    TRY(const CardModel* const model, models_.find(gl, *placement.instance->model));
    TRY_STATUS(draw(gl, input, placement, *model));
    ++instances_drawn_;
    triangles_drawn_ += model->triangle_count();
  }
  end_draw(gl);
  return base::Ok{};
}

void AliasPass::count(render::FrameStats& io_stats) const {
  io_stats.models = instances_drawn_;
  io_stats.triangles = triangles_drawn_;
}

base::Status AliasPass::draw_translucent(const Functions& gl, const FrameInput& input,
                                         const render::TranslucentLayer& layer, Target& io_target) {
  using Kind = render::TranslucentLayer::Kind;
  if (layer.kind != Kind::kAlias && layer.kind != Kind::kViewWeapon) return base::Ok{};
  const bool is_weapon_layer = layer.kind == Kind::kViewWeapon;
  const render::AliasInstance& instance =
      is_weapon_layer ? *input.scene().view_weapon : input.scene().alias_models[layer.number];
  if (instance.model == nullptr) return base::Ok{};
  const auto placement =
      render::place_alias(input.record.view, instance,
                          is_weapon_layer ? render::AliasRole::kViewWeapon : render::AliasRole::kWorld);
  if (!placement || placement->first_row >= placement->row_end ||
      placement->first_column >= placement->column_end)
    return base::Ok{};
  TRY(const CardModel* const model, models_.find(gl, *instance.model));
  TRY_STATUS(layer_.begin(
      gl, io_target,
      {placement->first_column, placement->first_row, placement->column_end - placement->first_column,
       placement->row_end - placement->first_row}));
  begin_draw(gl, input);
  TRY_STATUS(draw(gl, input, *placement, *model));
  end_draw(gl);
  return layer_.end(gl, input, instance.alpha, io_target);
}

// Sets what all instances share. If two triangles have equal depth, the later one shows, as on the CPU.
void AliasPass::begin_draw(const Functions& gl, const FrameInput& input) const {
  gl.UseProgram(program_.name());
  gl.ActiveTexture(GL_TEXTURE0 + kPalettesUnit);
  gl.BindTexture(GL_TEXTURE_2D, palettes_.texture());
  gl.ActiveTexture(GL_TEXTURE0 + kSkinsUnit);
  gl.Uniform1i(uniforms_.skins, kSkinsUnit);
  gl.Uniform1i(uniforms_.palettes, kPalettesUnit);
  gl.Uniform1i(uniforms_.full_range, gl.ClipControl == nullptr);
  const math::Vec3& fog_color = input.scene().fog.color;
  gl.Uniform3f(uniforms_.fog_color, fog_color.z, fog_color.y, fog_color.x);
  if (input.index_tables != nullptr) input.index_tables->use_fog(gl, index_);
  gl.ActiveTexture(GL_TEXTURE0 + kSkinsUnit);
  gl.Enable(GL_CULL_FACE);
  gl.DepthFunc(GL_GEQUAL);
}

void AliasPass::end_draw(const Functions& gl) const {
  gl.BindVertexArray(0);
  gl.DepthRangef(0, kWorldDepthEnd);
  gl.DepthFunc(GL_GREATER);
  gl.Disable(GL_CULL_FACE);
}

base::Status AliasPass::draw(const Functions& gl, const FrameInput& input,
                             const render::AliasPlacement& placement, const CardModel& model) const {
  const render::AliasInstance& instance = *placement.instance;
  set_vertex_uniforms(gl, input, placement);
  TRY_STATUS(set_light(gl, input, placement));
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, model.skin_texture());
  const SkinPlace skin = model.skin_place(instance.skin);
  gl.Uniform4i(uniforms_.skin, skin.first_row, skin.layer, skin.width, skin.height);
  gl.Uniform1i(uniforms_.palette, PlayerPalettes::row(instance.colors));
  model.draw(gl, instance.from_pose, instance.to_pose);
  return base::Ok{};
}

// The view weapon's depth is multiplied by a factor on the CPU, which also makes its fog thin.
void AliasPass::set_vertex_uniforms(const Functions& gl, const FrameInput& input,
                                    const render::AliasPlacement& placement) const {
  const render::ViewFrame& view = input.record.view;
  const render::VertexJob job = render::make_pose_job<std::uint8_t>(input.context, view, placement);
  gl.Uniform4fv(uniforms_.to_view, 3, &job.to_view[0][0]);
  gl.Uniform1f(uniforms_.pose_blend, job.blend);
  gl.Uniform4f(uniforms_.projection, 2 * job.pixels_per_unit / static_cast<float>(view.width),
               2 * job.pixels_per_unit / static_cast<float>(view.height), job.near_z,
               job.perspective ? 1.0f : 0.0f);
  gl.Uniform1f(uniforms_.fog_density, input.scene().fog.density / job.depth_scale);
  if (is_weapon(placement))
    gl.DepthRangef(kWorldDepthEnd, 1);
  else
    gl.DepthRangef(0, kWorldDepthEnd);
}

base::Status AliasPass::set_light(const Functions& gl, const FrameInput& input,
                                  const render::AliasPlacement& placement) const {
  const render::AliasLight light = render::choose_light(input.context, *placement.instance);
  const render::NormalLights lights = render::light_normals(light, placement, input.context.format);
  gl.Uniform4fv(uniforms_.lights, static_cast<GLsizei>(lights.size() / 4), lights.data());
  gl.Uniform3f(uniforms_.tint, light.color.z, light.color.y, light.color.x);
  return input.index_tables != nullptr ? set_light_tables(gl, input, light) : base::Ok{};
}

// The palettes' plain row changes no index, as white light does.
base::Status AliasPass::set_light_tables(const Functions& gl, const FrameInput& input,
                                         const render::AliasLight& light) const {
  constexpr int kLightRows = 64;
  const render::ColorTables& colors = input.context.colors;
  const bool is_white = light.tint_row == 0;
  gl.ActiveTexture(GL_TEXTURE0 + kTintsUnit);
  GLuint tints = palettes_.texture();
  if (!is_white) {
    TRY(tints, input.index_tables->find(gl, colors.tints.rows_for(light.tint_color), render::kTintRows));
  }
  gl.BindTexture(GL_TEXTURE_2D, tints);
  gl.ActiveTexture(GL_TEXTURE0 + kColormapUnit);
  TRY(const GLuint colormap, input.index_tables->find(gl, colors.colormap.rows.data(), kLightRows));
  gl.BindTexture(GL_TEXTURE_2D, colormap);
  gl.ActiveTexture(GL_TEXTURE0 + kSkinsUnit);
  gl.Uniform1i(uniforms_.colormap, kColormapUnit);
  gl.Uniform1i(uniforms_.tints, kTintsUnit);
  gl.Uniform1i(uniforms_.tint_row,
               is_white ? PlayerPalettes::row(std::nullopt) : static_cast<int>(light.tint_row));
  return base::Ok{};
}

}  // namespace temblor::render_gl
