#include "render_gl/injected_gl.h"

#include <algorithm>

#include "base/check.h"
#include "platform/egl/offscreen_context.h"

namespace temblor::render_gl {

namespace {

// OpenGL calls plain functions, so they find their object here.
thread_local InjectedGl* current = nullptr;

std::uint64_t texel_bytes(GLenum format) {
  switch (format) {
    case GL_R8:
    case GL_R8UI:
      return 1;
    case GL_RGBA32UI:
      return 16;
    default:
      return 4;
  }
}

// Counts a call; true if it is the one that fails.
bool is_failing(int& io_calls, int failing) {
  return io_calls++ == failing;
}

}  // namespace

struct InjectedGl::Wrappers {
  template <ObjectKind kKind, auto kMember>
  static void GL_APIENTRY generate(GLsizei count, GLuint* names) {
    (current->real_.*kMember)(count, names);
    for (GLsizei i = 0; i < count; ++i) current->bytes_[number(kKind, names[i])] = 0;
  }
  template <ObjectKind kKind, auto kMember>
  static void GL_APIENTRY remove(GLsizei count, const GLuint* names) {
    (current->real_.*kMember)(count, names);
    for (GLsizei i = 0; i < count; ++i) current->bytes_.erase(number(kKind, names[i]));
  }
  static GLuint GL_APIENTRY create_shader(GLenum kind) {
    const GLuint name = current->real_.CreateShader(kind);
    current->bytes_[number(ObjectKind::kShader, name)] = 0;
    return name;
  }
  static GLuint GL_APIENTRY create_program() {
    const GLuint name = current->real_.CreateProgram();
    current->bytes_[number(ObjectKind::kProgram, name)] = 0;
    return name;
  }
  static void GL_APIENTRY delete_shader(GLuint name) {
    current->real_.DeleteShader(name);
    current->bytes_.erase(number(ObjectKind::kShader, name));
  }
  static void GL_APIENTRY delete_program(GLuint name) {
    current->real_.DeleteProgram(name);
    current->bytes_.erase(number(ObjectKind::kProgram, name));
  }
  static GLenum GL_APIENTRY get_reset_status() { return current->faults.reset_status; }
  static void GL_APIENTRY get_integer(GLenum name, GLint* out) {
    const auto found = current->faults.integers.find(name);
    if (found != current->faults.integers.end())
      *out = found->second;
    else
      current->real_.GetIntegerv(name, out);
  }
  static void GL_APIENTRY get_shader(GLuint shader, GLenum name, GLint* out) {
    current->real_.GetShaderiv(shader, name, out);
    if (name == GL_COMPILE_STATUS && is_failing(current->calls.compile, current->faults.compile))
      *out = GL_FALSE;
  }
  static void GL_APIENTRY get_program(GLuint program, GLenum name, GLint* out) {
    current->real_.GetProgramiv(program, name, out);
    if (name == GL_LINK_STATUS && is_failing(current->calls.link, current->faults.link)) *out = GL_FALSE;
  }
  static GLenum GL_APIENTRY check_framebuffer(GLenum target) {
    if (is_failing(current->calls.framebuffer, current->faults.framebuffer))
      return GL_FRAMEBUFFER_UNSUPPORTED;
    return current->real_.CheckFramebufferStatus(target);
  }
  static void GL_APIENTRY bind_texture(GLenum target, GLuint name) {
    current->bound_[target] = name;
    current->real_.BindTexture(target, name);
  }
  static void GL_APIENTRY bind_buffer(GLenum target, GLuint name) {
    current->bound_[target] = name;
    current->real_.BindBuffer(target, name);
  }
  static void GL_APIENTRY fill_buffer(GLenum target, GLsizeiptr size, const void* data, GLenum usage) {
    if (is_failing(current->calls.buffer, current->faults.buffer)) {
      current->error_ = GL_OUT_OF_MEMORY;
      return;
    }
    current->bytes_.at(number(ObjectKind::kBuffer, current->bound_[target])) =
        static_cast<std::uint64_t>(size);
    current->real_.BufferData(target, size, data, usage);
  }
  static void GL_APIENTRY store_2d(GLenum target, GLsizei levels, GLenum format, GLsizei width,
                                   GLsizei height) {
    if (current->begin_texture(target, format, width, height, 1))
      current->real_.TexStorage2D(target, levels, format, width, height);
  }
  static void GL_APIENTRY store_3d(GLenum target, GLsizei levels, GLenum format, GLsizei width,
                                   GLsizei height, GLsizei layers) {
    if (current->begin_texture(target, format, width, height, layers))
      current->real_.TexStorage3D(target, levels, format, width, height, layers);
  }
  static GLenum GL_APIENTRY get_error() {
    const GLenum injected = std::exchange(current->error_, GLenum{GL_NO_ERROR});
    const GLenum real = current->real_.GetError();
    return injected != GL_NO_ERROR ? injected : real;
  }

  template <typename Function>
  static void* address(Function* function) {
    return reinterpret_cast<void*>(function);
  }
  static std::unordered_map<std::string, void*> table() {
    using enum ObjectKind;
    return {{"glGenBuffers", address(&generate<kBuffer, &Functions::GenBuffers>)},
            {"glGenTextures", address(&generate<kTexture, &Functions::GenTextures>)},
            {"glGenFramebuffers", address(&generate<kFramebuffer, &Functions::GenFramebuffers>)},
            {"glGenVertexArrays", address(&generate<kVertexArray, &Functions::GenVertexArrays>)},
            {"glDeleteBuffers", address(&remove<kBuffer, &Functions::DeleteBuffers>)},
            {"glDeleteTextures", address(&remove<kTexture, &Functions::DeleteTextures>)},
            {"glDeleteFramebuffers", address(&remove<kFramebuffer, &Functions::DeleteFramebuffers>)},
            {"glDeleteVertexArrays", address(&remove<kVertexArray, &Functions::DeleteVertexArrays>)},
            {"glCreateShader", address(&create_shader)},
            {"glCreateProgram", address(&create_program)},
            {"glDeleteShader", address(&delete_shader)},
            {"glDeleteProgram", address(&delete_program)},
            {"glGetIntegerv", address(&get_integer)},
            {"glGetGraphicsResetStatus", address(&get_reset_status)},
            {"glGetGraphicsResetStatusKHR", address(&get_reset_status)},
            {"glGetShaderiv", address(&get_shader)},
            {"glGetProgramiv", address(&get_program)},
            {"glCheckFramebufferStatus", address(&check_framebuffer)},
            {"glBindTexture", address(&bind_texture)},
            {"glBindBuffer", address(&bind_buffer)},
            {"glBufferData", address(&fill_buffer)},
            {"glTexStorage2D", address(&store_2d)},
            {"glTexStorage3D", address(&store_3d)},
            {"glGetError", address(&get_error)}};
  }
};

base::Result<std::unique_ptr<InjectedGl>> InjectedGl::make() {
  CHECK(current == nullptr, "two on one thread");
  auto made = std::make_unique<InjectedGl>();
  TRY(made->context_, platform::egl::make_offscreen_context());
  TRY(made->real_, load_functions([context = made->context_.get()](const char* name) {
        return context->find_function(name);
      }));
  current = made.get();
  return made;
}

InjectedGl::~InjectedGl() {
  if (current == this) current = nullptr;
}

FunctionFinder InjectedGl::finder() {
  return [this, wrappers = Wrappers::table()](const char* name) -> void* {
    if (faults.missing_function == name) return nullptr;
    const auto found = wrappers.find(name);
    return found != wrappers.end() ? found->second : context_->find_function(name);
  };
}

std::uint64_t InjectedGl::live_bytes() const {
  std::uint64_t sum = 0;
  for (const auto& [object, bytes] : bytes_) sum += bytes;
  return sum;
}

bool InjectedGl::exceeds(GLenum limit, GLsizei size) const {
  const auto found = faults.integers.find(limit);
  return found != faults.integers.end() && size > found->second;
}

bool InjectedGl::begin_texture(GLenum target, GLenum format, GLsizei width, GLsizei height, GLsizei layers) {
  if (is_failing(calls.texture, faults.texture)) error_ = faults.texture_error;
  if (exceeds(GL_MAX_TEXTURE_SIZE, std::max(width, height)) || exceeds(GL_MAX_ARRAY_TEXTURE_LAYERS, layers))
    error_ = GL_INVALID_VALUE;
  if (error_ != GL_NO_ERROR) return false;
  bytes_.at(number(ObjectKind::kTexture, bound_[target])) =
      texel_bytes(format) * static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) *
      static_cast<std::uint64_t>(layers);
  return true;
}

}  // namespace temblor::render_gl
