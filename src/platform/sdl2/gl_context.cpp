#include "platform/sdl2/gl_context.h"

#include <SDL_opengl.h>
#include <fmt/format.h>

#include <array>
#include <optional>
#include <utility>

#include "base/software_driver.h"

namespace temblor::platform::sdl2 {
namespace {

class SdlGlContext : public WindowGlContext {
 public:
  SdlGlContext(const GlWindow& gl_window, SDL_GLContext context) : gl_window_(gl_window), context_(context) {}
  ~SdlGlContext() override { SDL_GL_DeleteContext(context_); }
  SdlGlContext(const SdlGlContext&) = delete;
  SdlGlContext& operator=(const SdlGlContext&) = delete;

  base::Status make_current() override {
    if (SDL_GL_MakeCurrent(gl_window_.window, context_) != 0)
      return base::error(base::ErrorCode::kIo, "the OpenGL context is lost ({})", SDL_GetError());
    return base::Ok{};
  }

  bool is_software() const override { return has_software_driver(); }

  void* find_function(const char* name) const override { return SDL_GL_GetProcAddress(name); }

  void show() override {
    // Displays without vsync refuse it, and show the picture at once.
    if (vsync_ != gl_window_.vsync) SDL_GL_SetSwapInterval(gl_window_.vsync ? 1 : 0);
    vsync_ = gl_window_.vsync;
    SDL_GL_SwapWindow(gl_window_.window);
  }

 private:
  const GlWindow& gl_window_;
  SDL_GLContext context_;
  std::optional<bool> vsync_;  // of the display; nothing: not set yet
};

struct Version {
  int profile, major, minor;
  int reset_notification;  // the context reports when it is lost
};

// Null if the driver lacks it.
SDL_GLContext create_context(SDL_Window* window, const Version& version) {
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, version.profile);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, version.major);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, version.minor);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_RESET_NOTIFICATION, version.reset_notification);
#ifndef NDEBUG
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_FLAGS, SDL_GL_CONTEXT_DEBUG_FLAG);
#endif
  return SDL_GL_CreateContext(window);
}

}  // namespace

base::Result<std::unique_ptr<WindowGlContext>> make_gl_context(const GlWindow& gl_window) {
  constexpr int kReports = SDL_GL_CONTEXT_RESET_LOSE_CONTEXT, kSilent = SDL_GL_CONTEXT_RESET_NO_NOTIFICATION;
  constexpr std::array<Version, 4> kVersions = {{{SDL_GL_CONTEXT_PROFILE_CORE, 3, 3, kReports},
                                                 {SDL_GL_CONTEXT_PROFILE_CORE, 3, 3, kSilent},
                                                 {SDL_GL_CONTEXT_PROFILE_ES, 3, 0, kReports},
                                                 {SDL_GL_CONTEXT_PROFILE_ES, 3, 0, kSilent}}};
  SDL_GLContext context = nullptr;
  for (const Version& version : kVersions)
    if (context == nullptr) context = create_context(gl_window.window, version);
  const std::string reason = SDL_GetError();
  // SDL's own renderer makes another window if it finds attributes of ours.
  SDL_GL_ResetAttributes();
  if (context == nullptr)
    return base::error(base::ErrorCode::kUnsupported,
                       "the window has no OpenGL 3.3 and no OpenGL ES 3.0 ({})", reason);
  return std::unique_ptr<WindowGlContext>(std::make_unique<SdlGlContext>(gl_window, context));
}

bool has_software_driver() {
  using GetString = const GLubyte*(APIENTRY*)(GLenum);
  const auto get_string = reinterpret_cast<GetString>(SDL_GL_GetProcAddress("glGetString"));
  const GLubyte* const name = get_string == nullptr ? nullptr : get_string(GL_RENDERER);
  return name != nullptr && base::is_software_driver(reinterpret_cast<const char*>(name));
}

std::string describe_gl(const GlWindow& gl_window) {
  return fmt::format("{}, OpenGL, {} vsync", SDL_GetCurrentVideoDriver(),
                     gl_window.vsync ? "with" : "without");
}

}  // namespace temblor::platform::sdl2
