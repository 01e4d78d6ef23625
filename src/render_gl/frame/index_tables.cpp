#include "render_gl/frame/index_tables.h"

#include <algorithm>

#include "render/color/blend_tables.h"

namespace temblor::render_gl {

namespace {

// Passes use lower ones.
constexpr GLint kFogUnit = 8, kBelowTablesUnit = 9, kBlendUnit = 10, kDimUnit = 11;
constexpr int kIndices = 256;

void upload_rows(const Functions& gl, const Texture& texture, const std::uint8_t* rows, int count) {
  gl.BindTexture(GL_TEXTURE_2D, texture.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kIndices, count, GL_RED, GL_UNSIGNED_BYTE, rows);
}

void use_texture(const Functions& gl, GLint location, GLint unit, GLuint texture) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.Uniform1i(location, unit);
}

}  // namespace

IndexUniforms::IndexUniforms(const Functions& gl, const Program& program)
    : fog_table(gl.GetUniformLocation(program.name(), "fog_table")),
      below(gl.GetUniformLocation(program.name(), "below")),
      blend_table(gl.GetUniformLocation(program.name(), "blend_table")),
      dim_table(gl.GetUniformLocation(program.name(), "dim_table")),
      dim_column(gl.GetUniformLocation(program.name(), "dim_column")) {}

base::Status IndexTables::set_fog(const Functions& gl, const std::uint8_t* rows) {
  constexpr int kRows = render::FogTables::kRows;
  const std::span<const std::uint8_t> wanted(rows, rows == nullptr ? 0 : std::size_t{kRows} * kIndices);
  if (rows == nullptr || std::ranges::equal(fog_rows_, wanted)) return base::Ok{};
  if (!fog_) {
    TRY(fog_, make_texture(gl, GL_R8, {kIndices, kRows}));
  }
  upload_rows(gl, fog_, rows, kRows);
  fog_rows_.assign(wanted.begin(), wanted.end());
  return base::Ok{};
}

base::Result<GLuint> IndexTables::find(const Functions& gl, const std::uint8_t* table, int rows) {
  const auto found = tables_.find(table);
  if (found != tables_.end()) return found->second.name();
  TRY(Texture texture, make_texture(gl, GL_R8, {kIndices, rows}));
  upload_rows(gl, texture, table, rows);
  return tables_.emplace(table, std::move(texture)).first->second.name();
}

void IndexTables::use_fog(const Functions& gl, const IndexUniforms& uniforms) const {
  use_texture(gl, uniforms.fog_table, kFogUnit, fog_.name());
}

base::Status IndexTables::use_blend(const Functions& gl, const IndexUniforms& uniforms,
                                    const IndexBlend& blend, const PixelRect& rect, Target& io_target) {
  // Making a texture binds it, so units are set when all textures exist.
  gl.ActiveTexture(GL_TEXTURE0 + kBelowTablesUnit);
  TRY(const GLuint table, find(gl, blend.table, kIndices));
  TRY(const GLuint dims, find(gl, blend.dims == nullptr ? blend.table : blend.dims, kIndices));
  TRY(const GLuint below, io_target.copy(gl, rect));
  use_texture(gl, uniforms.below, kBelowTablesUnit, below);
  use_texture(gl, uniforms.blend_table, kBlendUnit, table);
  use_texture(gl, uniforms.dim_table, kDimUnit, dims);
  gl.Uniform1i(uniforms.dim_column, blend.dims == nullptr ? -1 : blend.dim_column);
  return base::Ok{};
}

}  // namespace temblor::render_gl
