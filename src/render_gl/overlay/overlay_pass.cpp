#include "render_gl/overlay/overlay_pass.h"

#include <algorithm>
#include <string>

#include "render/color/blend_tables.h"
#include "render_gl/gl/shader_look.h"
#include "render_gl/overlay/overlay_shaders.h"

namespace temblor::render_gl {

namespace {

constexpr GLint kPictureUnit = 0, kColorsUnit = 1, kBelowUnit = 2;
constexpr int kMinColorRows = 16;

bool is_combined(const render::DrawCommand& command, render::PixelFormat format) {
  if (command.mode != render::DrawMode::kBlend) return true;
  return format == render::PixelFormat::kIndexed && command.opacity < 1;
}

std::int32_t pack_factor(const render::DrawCommand& command) {
  const formats::Rgb factor = command.tint != nullptr ? command.tint->factor : formats::Rgb{255, 255, 255};
  return factor.b | factor.g << 8 | factor.r << 16;
}

OverlayQuad make_quad(const render::DrawCommand& command, const render::OverlayClip& clip,
                      const OverlayTexture& texture) {
  OverlayQuad quad{};
  quad.rect = {static_cast<std::int32_t>(clip.x_first), static_cast<std::int32_t>(clip.y_first),
               static_cast<std::int32_t>(clip.x_end), static_cast<std::int32_t>(clip.y_end)};
  quad.opacity_256 = render::opacity_256(command.opacity);
  quad.fill = command.fill;
  quad.factor = pack_factor(command);
  if (command.picture == nullptr) return quad;
  const render::OverlayPart part = render::find_part(command);
  const formats::Picture& picture = *command.picture;
  const render::ScreenRect& area = command.area;
  quad.columns = make_texel_axis(
      {area.x, area.width, clip.x_first, command.part_x, part.width, picture.width, texture.width});
  quad.rows = make_texel_axis(
      {area.y, area.height, clip.y_first, command.part_y, part.height, picture.height, texture.height});
  return quad;
}

}  // namespace

OverlayPass::OverlayProgram::OverlayProgram(const Functions& gl, Program made)
    : program(std::move(made)),
      pixel_size(gl.GetUniformLocation(program.name(), "pixel_size")),
      picture(gl.GetUniformLocation(program.name(), "picture")),
      colors(gl.GetUniformLocation(program.name(), "colors")),
      below(gl.GetUniformLocation(program.name(), "below")),
      product(gl.GetUniformLocation(program.name(), "product")),
      index(gl, program) {}

OverlayPass::OverlayPass(const Functions& gl, render::PixelFormat format)
    : format_(format), vertex_array_(make_vertex_array(gl)), buffer_(make_buffer(gl)) {}

base::Result<OverlayPass> OverlayPass::make(const Functions& gl, render::PixelFormat format) {
  const bool is_indexed = format == render::PixelFormat::kIndexed;
  OverlayPass pass(gl, format);
  constexpr std::array<const char*, 3> kDefines = {"#define FILL\n", "", "#define DETAIL\n"};
  for (const bool combines : {false, true})
    for (std::size_t kind = 0; kind < kDefines.size(); ++kind) {
      if (is_indexed && kind == static_cast<std::size_t>(Kind::kDetail)) continue;
      const ShaderLook look = is_indexed && combines ? ShaderLook::kBlendedIndices : find_look(format);
      const std::string source = kDefines[kind] + look_part(look) + kOverlayPart +
                                 (combines ? kCombinedFragmentShader : kOverlayFragmentShader);
      TRY(Program program, make_program(gl, kOverlayVertexShader, source.c_str()));
      pass.programs_[combines][kind].emplace(gl, std::move(program));
    }
  return pass;
}

base::Result<bool> OverlayPass::draw(const Functions& gl, const render::DrawList& list,
                                     const render::ColorTables& tables, IndexTables& io_index_tables,
                                     Target& io_target) {
  render::check_commands(list);
  const auto can_draw_it = [&](const render::DrawCommand& command) { return can_draw(command, io_target); };
  if (!std::ranges::all_of(list.commands, can_draw_it)) return false;
  textures_.begin_frame();
  for (std::span<const render::DrawCommand> rest(list.commands); !rest.empty();) {
    TRY(const std::size_t taken, collect(gl, rest, tables, io_target));
    rest = rest.subspan(taken);
    TRY_STATUS(upload(gl));
    io_target.bind(gl);
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    gl.Disable(GL_DEPTH_TEST);
    gl.BindVertexArray(vertex_array_.name());
    for (const Batch& batch : batches_) TRY_STATUS(draw_batch(gl, batch, tables, io_index_tables, io_target));
    gl.BindVertexArray(0);
  }
  TRY_STATUS(gl.check("drawing the overlay"));
  return true;
}

namespace {

render::OverlayClip clip_to_target(const render::DrawCommand& command, const Target& target) {
  return render::clip_command(command, {0, target.width(), 0, target.height()});
}

bool shows_nothing(const render::DrawCommand& command, const Target& target) {
  return clip_to_target(command, target).is_empty() || !(command.opacity > 0);
}

}  // namespace

bool OverlayPass::can_draw(const render::DrawCommand& command, const Target& target) const {
  using render::DrawMode;
  if (format_ == render::PixelFormat::kRgb || shows_nothing(command, target)) return true;
  if (command.mode == DrawMode::kMultiply || command.mode == DrawMode::kMultiplyTwice) return false;
  return !render::shows_detail(command);
}

base::Result<std::size_t> OverlayPass::collect(const Functions& gl,
                                               std::span<const render::DrawCommand> commands,
                                               const render::ColorTables& tables, const Target& target) {
  quads_.clear();
  batches_.clear();
  colors_.begin(tables, format_);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const render::DrawCommand& command = commands[i];
    if (shows_nothing(command, target)) continue;
    const std::int32_t row = colors_.find_row(command);
    if (row < 0) return i;
    Batch batch{quads_.size(), 1, Kind::kFill, 0, is_combined(command, format_) ? &command : nullptr};
    OverlayTexture texture{0, 1, 1};
    if (command.picture != nullptr) {
      const bool has_detail = render::shows_detail(command);
      TRY(texture,
          has_detail ? textures_.find(gl, command.picture->detail) : textures_.find(gl, *command.picture));
      batch.kind = has_detail ? Kind::kDetail : Kind::kPicture;
      batch.texture = texture.name;
    }
    quads_.push_back(make_quad(command, clip_to_target(command, target), texture));
    quads_.back().color_row = row;
    add_batch(batch);
  }
  return commands.size();
}

// Combined commands read what was drawn before.
void OverlayPass::add_batch(const Batch& batch) {
  Batch* const last = batches_.empty() ? nullptr : &batches_.back();
  if (last != nullptr && last->combined == nullptr && batch.combined == nullptr && last->kind == batch.kind &&
      last->texture == batch.texture)
    ++last->count;
  else
    batches_.push_back(batch);
}

base::Status OverlayPass::upload(const Functions& gl) {
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(quads_.size() * sizeof(OverlayQuad)), quads_.data(),
                GL_STREAM_DRAW);
  if (std::ranges::equal(colors_.texels(), uploaded_colors_)) return base::Ok{};
  uploaded_colors_.clear();  // stays so if the upload fails
  const std::size_t rows = colors_.texels().size() / 256;
  gl.ActiveTexture(GL_TEXTURE0 + kColorsUnit);
  if (rows > color_rows_) {
    const std::size_t wanted =
        std::max<std::size_t>(kMinColorRows, std::min(2 * rows, OverlayColors::kMaxRows));
    TRY(color_texture_, make_texture(gl, GL_RGBA8, {256, static_cast<int>(wanted)}));
    color_rows_ = wanted;
  }
  gl.BindTexture(GL_TEXTURE_2D, color_texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 256, static_cast<GLsizei>(rows), GL_RGBA, GL_UNSIGNED_BYTE,
                   colors_.texels().data());
  uploaded_colors_.assign(colors_.texels().begin(), colors_.texels().end());
  return base::Ok{};
}

base::Status OverlayPass::draw_batch(const Functions& gl, const Batch& batch,
                                     const render::ColorTables& tables, IndexTables& io_index_tables,
                                     Target& io_target) const {
  const OverlayProgram& program = *programs_[batch.combined != nullptr][static_cast<std::size_t>(batch.kind)];
  gl.UseProgram(program.program.name());
  if (batch.combined != nullptr) {
    const render::DrawCommand& command = *batch.combined;
    const std::array<std::int32_t, 4>& rect = quads_[batch.first].rect;
    const PixelRect pixels{rect[0], rect[1], rect[2] - rect[0], rect[3] - rect[1]};
    if (format_ == render::PixelFormat::kIndexed) {
      const IndexBlend blend{.table = command.mode == render::DrawMode::kAdd
                                          ? tables.blends.sums()
                                          : tables.blends.table_for(command.opacity)};
      TRY_STATUS(io_index_tables.use_blend(gl, program.index, blend, pixels, io_target));
    } else {
      gl.ActiveTexture(GL_TEXTURE0 + kBelowUnit);
      TRY(const GLuint below, io_target.copy(gl, pixels));
      gl.BindTexture(GL_TEXTURE_2D, below);
      gl.Uniform1i(program.below, kBelowUnit);
      const bool is_double = command.mode == render::DrawMode::kMultiplyTwice;
      gl.Uniform1i(program.product, command.mode == render::DrawMode::kAdd ? 0 : is_double ? 2 : 1);
    }
  } else if (format_ == render::PixelFormat::kRgb) {
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
  gl.ActiveTexture(GL_TEXTURE0 + kColorsUnit);
  gl.BindTexture(GL_TEXTURE_2D, color_texture_.name());
  gl.ActiveTexture(GL_TEXTURE0 + kPictureUnit);
  gl.BindTexture(GL_TEXTURE_2D, batch.texture);
  gl.Uniform1i(program.colors, kColorsUnit);
  gl.Uniform1i(program.picture, kPictureUnit);
  gl.Uniform2f(program.pixel_size, 2.0f / static_cast<float>(io_target.width()),
               2.0f / static_cast<float>(io_target.height()));
  // Instances begin at the batch's: neither OpenGL ES nor OpenGL 3.3 has a draw call that says so.
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer_.name());
  for (GLuint location = 0; location < sizeof(OverlayQuad) / sizeof(TexelAxis); ++location) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribDivisor(location, 1);
    gl.VertexAttribIPointer(
        location, 4, GL_INT, sizeof(OverlayQuad),
        reinterpret_cast<const void*>(batch.first * sizeof(OverlayQuad) + location * sizeof(TexelAxis)));
  }
  gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(batch.count));
  gl.Disable(GL_BLEND);
  return base::Ok{};
}

}  // namespace temblor::render_gl
