// Objects of OpenGL as values that delete what they own. They must be deleted while their context is current,
// and refer to its Functions, which must live longer.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "render_gl/gl/functions.h"

namespace temblor::render_gl {

// The name of an object, which is deleted by `Delete`, a static function.
template <void (*Delete)(const Functions& gl, GLuint name)>
class Object {
 public:
  Object() = default;  // owns nothing
  Object(const Functions& gl, GLuint name) : gl_(&gl), name_(name) {}
  Object(Object&& other) noexcept : gl_(other.gl_), name_(std::exchange(other.name_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(gl_, other.gl_);
    std::swap(name_, other.name_);
    return *this;
  }
  ~Object() {
    if (name_ != 0) Delete(*gl_, name_);
  }

  GLuint name() const { return name_; }
  explicit operator bool() const { return name_ != 0; }

 private:
  const Functions* gl_ = nullptr;
  GLuint name_ = 0;
};

namespace deleting {
inline void buffer(const Functions& gl, GLuint name) {
  gl.DeleteBuffers(1, &name);
}
inline void texture(const Functions& gl, GLuint name) {
  gl.DeleteTextures(1, &name);
}
inline void framebuffer(const Functions& gl, GLuint name) {
  gl.DeleteFramebuffers(1, &name);
}
inline void vertex_array(const Functions& gl, GLuint name) {
  gl.DeleteVertexArrays(1, &name);
}
inline void query(const Functions& gl, GLuint name) {
  gl.DeleteQueries(1, &name);
}
inline void program(const Functions& gl, GLuint name) {
  gl.DeleteProgram(name);
}
}  // namespace deleting

using Buffer = Object<deleting::buffer>;
using Texture = Object<deleting::texture>;
using Framebuffer = Object<deleting::framebuffer>;
using VertexArray = Object<deleting::vertex_array>;
using Query = Object<deleting::query>;
using Program = Object<deleting::program>;

Buffer make_buffer(const Functions& gl);
Framebuffer make_framebuffer(const Functions& gl);
VertexArray make_vertex_array(const Functions& gl);

// A texture without filter and mip levels, whose texels shaders fetch by number. It stays bound to `target`.
// `layers`: 0 for GL_TEXTURE_2D. `levels`: of mip levels. Fails with kIo if there is not enough memory.
struct TextureSize {
  int width, height, layers = 0, levels = 1;
};
base::Result<Texture> make_texture(const Functions& gl, GLenum format, TextureSize size);

// Compiles and links. The sources lack the line of the version, which differs between OpenGL and OpenGL ES.
// Fails with kUnsupported and the driver's message.
base::Result<Program> make_program(const Functions& gl, const char* vertex_source,
                                   const char* fragment_source);

}  // namespace temblor::render_gl
