#include "render_gl/gl/functions.h"

#include <array>
#include <string_view>

#include "base/software_driver.h"

namespace temblor::render_gl {

namespace {

using base::ErrorCode;

std::string read_string(const Functions& gl, GLenum name) {
  const GLubyte* const text = gl.GetString(name);
  return text == nullptr ? "unknown" : reinterpret_cast<const char*>(text);
}

bool has_extension(const Functions& gl, std::string_view wanted) {
  GLint count = 0;
  gl.GetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const GLubyte* const name = gl.GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (name != nullptr && reinterpret_cast<const char*>(name) == wanted) return true;
  }
  return false;
}

constexpr GLenum kContextLost = 0x0507;  // GL_CONTEXT_LOST of OpenGL ES 3.2 and OpenGL 4.5

// OpenGL 2 and OpenGL ES 2 do not know the names of these numbers, and leave them 0. The shaders for OpenGL
// need 3.3.
base::Status check_version(const Functions& gl) {
  constexpr int kMinEs = 30, kMinDesktop = 33;
  GLint major = 0, minor = 0;
  gl.GetIntegerv(GL_MAJOR_VERSION, &major);
  gl.GetIntegerv(GL_MINOR_VERSION, &minor);
  const bool is_es = read_string(gl, GL_VERSION).starts_with("OpenGL ES");
  if (major * 10 + minor >= (is_es ? kMinEs : kMinDesktop)) return base::Ok{};
  return base::error(ErrorCode::kUnsupported,
                     "the OpenGL driver is too old ({}); OpenGL 3.3 or OpenGL ES 3.0 is needed",
                     describe_driver(gl));
}

// Drivers may give addresses for functions that they lack.
base::Status check_desktop_extensions(const Functions& gl) {
  for (const char* const name : {"GL_ARB_texture_storage", "GL_ARB_ES2_compatibility"})
    if (!has_extension(gl, name))
      return base::error(ErrorCode::kUnsupported, "the OpenGL driver is too old ({}): it lacks {}",
                         describe_driver(gl), name);
  return base::Ok{};
}

template <typename Function>
bool find_function(const FunctionFinder& find, const char* name, Function& out_function) {
  out_function = reinterpret_cast<Function>(find(name));
  return out_function != nullptr;
}

// Removes the driver's messages and returns the first one, as one line; empty if there is none.
std::string take_messages(const Functions& gl) {
  std::string first;
  if (gl.GetDebugMessageLog == nullptr) return first;
  std::array<char, 1024> text{};
  while (gl.GetDebugMessageLog(1, static_cast<GLsizei>(text.size()), nullptr, nullptr, nullptr, nullptr,
                               nullptr, text.data()) == 1) {
    const std::string_view message = text.data();
    if (first.empty()) first = message.substr(0, message.find('\n'));
  }
  return first;
}

// The driver keeps messages of high severity from now on, of which errors are the most. A callback would have
// to outlive the context. OpenGL ES has suffixes in the functions' names.
[[maybe_unused]] void begin_messages(const FunctionFinder& find, Functions& out_gl) {
  PFNGLDEBUGMESSAGECONTROLKHRPROC control = nullptr;
  const bool is_es = read_string(out_gl, GL_VERSION).starts_with("OpenGL ES");
  if (!find_function(find, is_es ? "glDebugMessageControlKHR" : "glDebugMessageControl", control)) return;
  find_function(find, is_es ? "glGetDebugMessageLogKHR" : "glGetDebugMessageLog", out_gl.GetDebugMessageLog);
  control(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  control(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_HIGH_KHR, 0, nullptr, GL_TRUE);
  take_messages(out_gl);  // older ones are not ours
}

}  // namespace

base::Status Functions::check(const char* doing) const {
  const std::string message = take_messages(*this);
  switch (const GLenum code = GetError()) {
    case GL_NO_ERROR:
      if (!message.empty()) return base::error(ErrorCode::kIo, "{}: {}", doing, message);
      return base::Ok{};
    case GL_OUT_OF_MEMORY:
      return base::error(ErrorCode::kIo, "{}: the graphics card is out of memory", doing);
    case kContextLost:
      return base::error(ErrorCode::kIo, "{}: the OpenGL context is lost", doing);
    default:
      return base::error(ErrorCode::kIo, "{}: OpenGL error {:#x}{}{}", doing, code,
                         message.empty() ? "" : ": ", message);
  }
}

base::Status Functions::check_context() const {
  if (GetGraphicsResetStatus == nullptr || GetGraphicsResetStatus() == GL_NO_ERROR) return base::Ok{};
  return base::error(ErrorCode::kIo, "the OpenGL context is lost: the graphics card was reset");
}

base::Result<Functions> load_functions(const FunctionFinder& find) {
  Functions gl;
  // First the version, since an old driver lacks functions, too.
  if (find_function(find, "glGetString", gl.GetString) &&
      find_function(find, "glGetIntegerv", gl.GetIntegerv))
    TRY_STATUS(check_version(gl));
#define TEMBLOR_GL_FIND(Type, Name)              \
  if (!find_function(find, "gl" #Name, gl.Name)) \
    return base::error(ErrorCode::kUnsupported, "the OpenGL driver has no gl" #Name);
  TEMBLOR_GL_FUNCTIONS(TEMBLOR_GL_FIND)
#undef TEMBLOR_GL_FIND
  if (has_extension(gl, "GL_EXT_clip_control"))
    find_function(find, "glClipControlEXT", gl.ClipControl);
  else if (has_extension(gl, "GL_ARB_clip_control"))
    find_function(find, "glClipControl", gl.ClipControl);
  gl.has_anisotropy = has_extension(gl, "GL_EXT_texture_filter_anisotropic") ||
                      has_extension(gl, "GL_ARB_texture_filter_anisotropic");
  const bool is_es = read_string(gl, GL_VERSION).starts_with("OpenGL ES");
  if (!is_es) TRY_STATUS(check_desktop_extensions(gl));
  gl.has_disjoint_timer = is_es && has_extension(gl, "GL_EXT_disjoint_timer_query");
  gl.has_timer = (!is_es || gl.has_disjoint_timer) && !base::is_software_driver(read_string(gl, GL_RENDERER));
  // ANGLE has the function without the suffix in OpenGL ES 3.0, too, where each call is an error.
  if (has_extension(gl, "GL_KHR_robustness"))
    find_function(find, is_es ? "glGetGraphicsResetStatusKHR" : "glGetGraphicsResetStatus",
                  gl.GetGraphicsResetStatus);
#ifndef NDEBUG
  if (has_extension(gl, "GL_KHR_debug")) begin_messages(find, gl);
#endif
  return gl;
}

std::string describe_driver(const Functions& gl) {
  return read_string(gl, GL_RENDERER) + ", " + read_string(gl, GL_VERSION);
}

}  // namespace temblor::render_gl
