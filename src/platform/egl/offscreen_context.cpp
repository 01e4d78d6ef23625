#include "platform/egl/offscreen_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <initializer_list>
#include <utility>
#include <vector>

namespace temblor::platform::egl {

namespace {

using base::ErrorCode;

// The functions of EGL that we call, from the library that was loaded.
struct Egl {
  decltype(&eglGetProcAddress) get_proc_address = nullptr;
  PFNEGLGETPLATFORMDISPLAYEXTPROC get_platform_display = nullptr;
  decltype(&eglInitialize) initialize = nullptr;
  decltype(&eglBindAPI) bind_api = nullptr;
  decltype(&eglCreateContext) create_context = nullptr;
  decltype(&eglMakeCurrent) make_current = nullptr;
  decltype(&eglGetCurrentContext) get_current_context = nullptr;
  decltype(&eglDestroyContext) destroy_context = nullptr;
  decltype(&eglGetError) get_error = nullptr;
};

template <typename Function>
bool find(void* library, const char* name, Function& out_function) {
  out_function = reinterpret_cast<Function>(dlsym(library, name));
  return out_function != nullptr;
}

// The library stays loaded until the program ends: drivers do not expect to be unloaded.
base::Result<Egl> load_egl() {
  void* const library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    return base::error(ErrorCode::kUnsupported, "OpenGL is missing: the system has no libEGL.so.1");
  Egl egl;
  if (!find(library, "eglGetProcAddress", egl.get_proc_address) ||
      !find(library, "eglInitialize", egl.initialize) || !find(library, "eglBindAPI", egl.bind_api) ||
      !find(library, "eglCreateContext", egl.create_context) ||
      !find(library, "eglMakeCurrent", egl.make_current) ||
      !find(library, "eglGetCurrentContext", egl.get_current_context) ||
      !find(library, "eglDestroyContext", egl.destroy_context) ||
      !find(library, "eglGetError", egl.get_error))
    return base::error(ErrorCode::kUnsupported, "libEGL.so.1 lacks functions of EGL 1.4");
  egl.get_platform_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(egl.get_proc_address("eglGetPlatformDisplayEXT"));
  if (egl.get_platform_display == nullptr)
    return base::error(ErrorCode::kUnsupported,
                       "OpenGL is missing: EGL offers no display without a window system");
  return egl;
}

class OffscreenContext final : public GlContext {
 public:
  OffscreenContext(const Egl& egl, EGLDisplay display, EGLContext context)
      : egl_(egl), display_(display), context_(context) {}
  // The display stays initialized, since every context of the process shares it. Another context of this
  // thread stays current.
  ~OffscreenContext() override {
    if (egl_.get_current_context() == context_)
      egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    egl_.destroy_context(display_, context_);
  }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  base::Status make_current() override {
    if (egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE)
      return base::error(ErrorCode::kIo, "the OpenGL context is lost (EGL error {:#x})",
                         static_cast<unsigned>(egl_.get_error()));
    return base::Ok{};
  }

  void* find_function(const char* name) const override {
    return reinterpret_cast<void*>(egl_.get_proc_address(name));
  }

 private:
  Egl egl_;
  EGLDisplay display_;
  EGLContext context_;
};

// A context that reports when it is lost, if there is one. Debug builds ask for one that reports errors, too.
// EGL_NO_CONTEXT if it fails.
EGLContext create_context(const Egl& egl, EGLDisplay display) {
  const std::vector<EGLint> plain = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0};
  const auto create = [&](std::initializer_list<EGLint> wishes) {
    std::vector<EGLint> attributes = plain;
    attributes.insert(attributes.end(), wishes);
    attributes.push_back(EGL_NONE);
    return egl.create_context(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
  };
  constexpr EGLint kStrategy = EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY_EXT;
  EGLContext context = EGL_NO_CONTEXT;
#ifndef NDEBUG
  context = create(
      {EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR, kStrategy, EGL_LOSE_CONTEXT_ON_RESET_EXT});
  if (context == EGL_NO_CONTEXT) context = create({EGL_CONTEXT_FLAGS_KHR, EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR});
#endif
  if (context == EGL_NO_CONTEXT) context = create({kStrategy, EGL_LOSE_CONTEXT_ON_RESET_EXT});
  if (context == EGL_NO_CONTEXT) context = create({});
  return context;
}

}  // namespace

base::Result<std::unique_ptr<GlContext>> make_offscreen_context() {
  TRY(const Egl egl, load_egl());
  const EGLDisplay display =
      egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || egl.initialize(display, nullptr, nullptr) != EGL_TRUE)
    return base::error(ErrorCode::kUnsupported, "OpenGL is missing: EGL starts no driver without a display");
  egl.bind_api(EGL_OPENGL_ES_API);
  const EGLContext context = create_context(egl, display);
  if (context == EGL_NO_CONTEXT)
    return base::error(ErrorCode::kUnsupported,
                       "the OpenGL driver is too old: it offers no OpenGL ES 3.0 (EGL error {:#x})",
                       static_cast<unsigned>(egl.get_error()));
  auto made = std::make_unique<OffscreenContext>(egl, display, context);
  TRY_STATUS(made->make_current());
  return std::unique_ptr<GlContext>(std::move(made));
}

}  // namespace temblor::platform::egl
