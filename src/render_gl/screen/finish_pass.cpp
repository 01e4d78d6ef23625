#include "render_gl/screen/finish_pass.h"

#include <algorithm>

#include "render_gl/screen/whole_picture.h"

namespace temblor::render_gl {

namespace {

constexpr GLenum kFinishedPictureUnit = 0, kSourcesUnit = 1;

// Floats hold the whole numbers of the tint exactly.
constexpr const char* kFinishFragmentShader = R"(
uniform sampler2D picture;
uniform usampler2D warp_sources;  // numbers of columns in row 0, of rows in row 1; modulo 2^32
uniform bool is_warped;
uniform vec4 tint;  // channels from 0 to 255, and opacity from 0 to 256

out vec4 color;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  if (is_warped) {
    uint number =
        texelFetch(warp_sources, ivec2(at.x, 0), 0).x + texelFetch(warp_sources, ivec2(at.y, 1), 0).x;
    uint width = uint(textureSize(picture, 0).x);
    at = ivec2(number % width, number / width);
  }
  vec3 own = floor(texelFetch(picture, at, 0).rgb * 255.0 + 0.5);
  color = vec4(floor((tint.rgb * tint.w + own * (256.0 - tint.w) + 128.0) / 256.0) / 255.0, 1.0);
}
)";

}  // namespace

FinishPass::FinishPass(const Functions& gl, Program program)
    : program_(std::move(program)),
      picture_(gl.GetUniformLocation(program_.name(), "picture")),
      warp_sources_(gl.GetUniformLocation(program_.name(), "warp_sources")),
      is_warped_(gl.GetUniformLocation(program_.name(), "is_warped")),
      tint_(gl.GetUniformLocation(program_.name(), "tint")),
      no_vertices_(make_vertex_array(gl)) {}

base::Result<FinishPass> FinishPass::make(const Functions& gl) {
  TRY(Program program, make_program(gl, kWholePictureShader, kFinishFragmentShader));
  return FinishPass(gl, std::move(program));
}

base::Status FinishPass::load_sources(const Functions& gl, const Target& target, double time_s) {
  render::find_warp_sources(target.width(), target.height(), time_s, sources_);
  const int size = std::max(target.width(), target.height());
  gl.ActiveTexture(GL_TEXTURE0 + kSourcesUnit);
  if (size > source_size_) {
    TRY(source_texture_, make_texture(gl, GL_R32UI, {size, 2}));
    source_size_ = size;
  }
  gl.BindTexture(GL_TEXTURE_2D, source_texture_.name());
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, target.width(), 1, GL_RED_INTEGER, GL_UNSIGNED_INT,
                   sources_.column.data());
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 1, target.height(), 1, GL_RED_INTEGER, GL_UNSIGNED_INT,
                   sources_.row.data());
  return base::Ok{};
}

base::Status FinishPass::draw(const Functions& gl, const render::Scene& scene, Target& io_target) {
  const render::PictureTint tint(scene.tint, io_target.format(), false);
  if (!scene.underwater && !tint.changes_pixels()) return base::Ok{};
  TRY(const GLuint picture, io_target.exchange(gl));
  if (scene.underwater) TRY_STATUS(load_sources(gl, io_target, scene.time_s));
  gl.UseProgram(program_.name());
  gl.ActiveTexture(GL_TEXTURE0 + kFinishedPictureUnit);
  gl.BindTexture(GL_TEXTURE_2D, picture);
  gl.Uniform1i(picture_, kFinishedPictureUnit);
  gl.Uniform1i(warp_sources_, kSourcesUnit);
  gl.Uniform1i(is_warped_, scene.underwater);
  const auto channel = [&](int shift) { return static_cast<float>(tint.color() >> shift & 255); };
  gl.Uniform4f(tint_, channel(0), channel(8), channel(16), static_cast<float>(tint.opacity()));
  draw_whole_picture(gl, no_vertices_);
  return gl.check("finishing the picture");
}

}  // namespace temblor::render_gl
