// A driver that refuses: the real one, with failures that a test asks for. It also counts the objects on the
// card, and the bytes of textures and buffers.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>

#include "platform/gl_context.h"
#include "render_gl/gl/functions.h"

namespace temblor::render_gl {

enum class ObjectKind : std::uint8_t { kBuffer, kTexture, kFramebuffer, kVertexArray, kShader, kProgram };

// Failures; none by default.
struct Faults {
  std::string missing_function = {};
  // Answers of glGetIntegerv. Textures beyond such a limit are refused with GL_INVALID_VALUE.
  std::map<GLenum, GLint> integers = {};
  // Fail for the call of this number, from 0; negative: never.
  int compile = -1, link = -1, framebuffer = -1, texture = -1, buffer = -1;
  GLenum texture_error = GL_OUT_OF_MEMORY;
  GLenum reset_status = GL_NO_ERROR;
};

// One at a time on each thread.
class InjectedGl {
 public:
  // Fails on machines without OpenGL.
  static base::Result<std::unique_ptr<InjectedGl>> make();
  ~InjectedGl();

  // Valid as long as this object.
  FunctionFinder finder();

  Faults faults;
  // Objects that were made and not deleted, and their bytes.
  std::size_t live_objects() const { return bytes_.size(); }
  std::uint64_t live_bytes() const;
  // How often something that can fail was called.
  struct Calls {
    int compile = 0, link = 0, framebuffer = 0, texture = 0, buffer = 0;
  };
  Calls calls;

 private:
  struct Wrappers;
  using Object = std::uint64_t;  // kind, name
  static Object number(ObjectKind kind, GLuint name) { return static_cast<std::uint64_t>(kind) << 32 | name; }
  bool exceeds(GLenum limit, GLsizei size) const;
  bool begin_texture(GLenum target, GLenum format, GLsizei width, GLsizei height, GLsizei layers);

  std::unique_ptr<platform::GlContext> context_;
  Functions real_;
  std::unordered_map<Object, std::uint64_t> bytes_;
  std::unordered_map<GLenum, GLuint> bound_;  // by target
  GLenum error_ = GL_NO_ERROR;
};

}  // namespace temblor::render_gl

// Declares `variable` as an InjectedGl, or skips the test with the driver's message.
#define INJECTED_GL_OR_SKIP(variable)                                                           \
  const auto variable##_result = ::temblor::render_gl::InjectedGl::make();                      \
  if (!variable##_result.ok()) GTEST_SKIP() << "no OpenGL: " << variable##_result.error().what; \
  ::temblor::render_gl::InjectedGl& variable = **variable##_result
