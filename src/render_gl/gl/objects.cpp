#include "render_gl/gl/objects.h"

#include <array>
#include <string_view>

namespace temblor::render_gl {

namespace {

using base::ErrorCode;

// The first line of a shader, and the precision of numbers, which OpenGL ES has no default for.
const char* shader_head(const Functions& gl) {
  const GLubyte* const version = gl.GetString(GL_VERSION);
  const std::string_view text = version == nullptr ? "" : reinterpret_cast<const char*>(version);
  if (!text.starts_with("OpenGL ES")) return "#version 330 core\n";
  return "#version 300 es\n"
         "precision highp float;\nprecision highp int;\n"
         "precision highp sampler2D;\nprecision highp sampler2DArray;\n"
         "precision highp usampler2D;\nprecision highp usampler2DArray;\n";
}

// The first line that a driver reports, without the end of the line.
template <typename GetLog>
std::string read_log(GetLog get_log) {
  std::array<char, 512> text{};
  get_log(static_cast<GLsizei>(text.size()), text.data());
  const std::string_view log = text.data();
  return std::string(log.substr(0, log.find('\n')));
}

base::Status compile(const Functions& gl, GLuint program, GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  const std::array<const char*, 2> sources = {shader_head(gl), source};
  gl.ShaderSource(shader, 2, sources.data(), nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = compiled == GL_TRUE ? "" : read_log([&](GLsizei size, char* text) {
    gl.GetShaderInfoLog(shader, size, nullptr, text);
  });
  gl.AttachShader(program, shader);
  gl.DeleteShader(shader);  // when the program is deleted
  if (compiled != GL_TRUE)
    return base::error(ErrorCode::kUnsupported, "the OpenGL driver does not compile a shader: {}", log);
  return base::Ok{};
}

}  // namespace

Buffer make_buffer(const Functions& gl) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  return {gl, name};
}

Framebuffer make_framebuffer(const Functions& gl) {
  GLuint name = 0;
  gl.GenFramebuffers(1, &name);
  return {gl, name};
}

VertexArray make_vertex_array(const Functions& gl) {
  GLuint name = 0;
  gl.GenVertexArrays(1, &name);
  return {gl, name};
}

base::Result<Texture> make_texture(const Functions& gl, GLenum format, TextureSize size) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  Texture texture(gl, name);
  const GLenum target = size.layers == 0 ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY;
  gl.BindTexture(target, name);
  if (size.layers == 0)
    gl.TexStorage2D(target, size.levels, format, size.width, size.height);
  else
    gl.TexStorage3D(target, size.levels, format, size.width, size.height, size.layers);
  gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.TexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  TRY_STATUS(gl.check("making a texture"));
  return texture;
}

base::Result<Program> make_program(const Functions& gl, const char* vertex_source,
                                   const char* fragment_source) {
  Program program(gl, gl.CreateProgram());
  TRY_STATUS(compile(gl, program.name(), GL_VERTEX_SHADER, vertex_source));
  TRY_STATUS(compile(gl, program.name(), GL_FRAGMENT_SHADER, fragment_source));
  gl.LinkProgram(program.name());
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  if (linked != GL_TRUE)
    return base::error(ErrorCode::kUnsupported, "the OpenGL driver does not link a shader: {}",
                       read_log([&](GLsizei length, char* text) {
                         gl.GetProgramInfoLog(program.name(), length, nullptr, text);
                       }));
  return program;
}

}  // namespace temblor::render_gl
