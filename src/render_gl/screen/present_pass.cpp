#include "render_gl/screen/present_pass.h"

#include "render_gl/gl/shader_look.h"
#include "render_gl/screen/whole_picture.h"

namespace temblor::render_gl {

namespace {

constexpr GLint kShownPictureUnit = 0, kShownColorsUnit = 1;

// The window's first row is the lowest one.
constexpr const char* kPresentFragmentShader = R"(
uniform sampler2D picture;
uniform sampler2D colors;  // 256 of them
uniform ivec2 picture_size, window_size;

out vec4 color;

vec3 find_color(ivec2 at) {
  vec3 own = texelFetch(picture, at, 0).bgr;
#ifdef INDEXED
  return texelFetch(colors, ivec2(to_index(own.b), 0), 0).rgb;
#elif !defined(TONED)
  return own;
#else
  ivec3 values = ivec3(own * 255.0 + 0.5);
  return vec3(texelFetch(colors, ivec2(values.r, 0), 0).r, texelFetch(colors, ivec2(values.g, 0), 0).g,
              texelFetch(colors, ivec2(values.b, 0), 0).b);
#endif
}

void main() {
#ifdef STRETCHED
  vec2 place = vec2(gl_FragCoord.x, float(window_size.y) - gl_FragCoord.y);
  vec2 source = place * vec2(picture_size) / vec2(window_size) - 0.5;
  vec2 share = source - floor(source);
  ivec2 first = max(ivec2(floor(source)), 0), second = min(ivec2(floor(source)) + 1, picture_size - 1);
  vec3 top = mix(find_color(first), find_color(ivec2(second.x, first.y)), share.x);
  vec3 bottom = mix(find_color(ivec2(first.x, second.y)), find_color(second), share.x);
  color = vec4(mix(top, bottom, share.y), 1.0);
#else
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  color = vec4(find_color(ivec2(pixel.x, window_size.y - 1 - pixel.y)), 1.0);
#endif
}
)";

}  // namespace

PresentPass::PresentProgram::PresentProgram(const Functions& gl, Program made)
    : program(std::move(made)),
      picture(gl.GetUniformLocation(program.name(), "picture")),
      colors(gl.GetUniformLocation(program.name(), "colors")),
      picture_size(gl.GetUniformLocation(program.name(), "picture_size")),
      window_size(gl.GetUniformLocation(program.name(), "window_size")) {}

PresentPass::PresentPass(const Functions& gl, Texture colors)
    : no_vertices_(make_vertex_array(gl)), color_texture_(std::move(colors)) {}

base::Result<PresentPass> PresentPass::make(const Functions& gl, render::PixelFormat format) {
  TRY(Texture colors, make_texture(gl, GL_RGBA8, {256, 1}));
  PresentPass pass(gl, std::move(colors));
  for (const bool is_stretched : {false, true})
    for (const bool has_tone : {false, true}) {
      if (has_tone && format == render::PixelFormat::kIndexed) continue;
      const std::string source = std::string(is_stretched ? "#define STRETCHED\n" : "") +
                                 (has_tone ? "#define TONED\n" : "") + look_part(find_look(format)) +
                                 kPresentFragmentShader;
      TRY(Program program, make_program(gl, kWholePictureShader, source.c_str()));
      pass.programs_[is_stretched][has_tone].emplace(gl, std::move(program));
    }
  return pass;
}

base::Status PresentPass::draw(const Functions& gl, const Target& target, const Shown& shown) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, shown.framebuffer);
  gl.Viewport(0, 0, shown.width, shown.height);
  const bool is_indexed = target.format() == render::PixelFormat::kIndexed;
  const bool is_stretched = shown.width != target.width() || shown.height != target.height();
  const PresentProgram& program = *programs_[is_stretched][!is_indexed && shown.tone != nullptr];
  gl.UseProgram(program.program.name());
  gl.ActiveTexture(GL_TEXTURE0 + kShownColorsUnit);
  gl.BindTexture(GL_TEXTURE_2D, color_texture_.name());
  if (is_indexed || shown.tone != nullptr) {
    std::array<std::array<std::uint8_t, 4>, 256> colors;
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const formats::Rgb& entry = shown.palette[i];
      const std::uint8_t value = shown.tone != nullptr ? (*shown.tone)[i] : std::uint8_t{0};
      colors[i] = is_indexed ? std::array<std::uint8_t, 4>{entry.r, entry.g, entry.b, 255}
                             : std::array<std::uint8_t, 4>{value, value, value, 255};
    }
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 256, 1, GL_RGBA, GL_UNSIGNED_BYTE, colors.data());
  }
  gl.ActiveTexture(GL_TEXTURE0 + kShownPictureUnit);
  gl.BindTexture(GL_TEXTURE_2D, target.color_texture());
  gl.Uniform1i(program.picture, kShownPictureUnit);
  gl.Uniform1i(program.colors, kShownColorsUnit);
  gl.Uniform2i(program.picture_size, target.width(), target.height());
  gl.Uniform2i(program.window_size, shown.width, shown.height);
  draw_whole_picture(gl, no_vertices_);
  return gl.check("showing the picture");
}

}  // namespace temblor::render_gl
