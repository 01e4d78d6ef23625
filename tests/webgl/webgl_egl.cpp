// A libEGL.so.1 whose contexts are those of WebGL 2: ANGLE, the OpenGL of Chromium, checks each call against
// the rules of WebGL before it draws with SwiftShader. tools/check_webgl.sh runs tests with it, unchanged.
//
// TEMBLOR_ANGLE names the folder of ANGLE's libraries. Only the functions that src/platform/egl calls are
// here.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

namespace {

// Numbers of ANGLE's extensions of EGL: EGL_ANGLE_platform_angle,
// EGL_ANGLE_platform_angle_device_type_swiftshader, and EGL_ANGLE_create_context_webgl_compatibility.
constexpr EGLenum kPlatformAngle = 0x3202;
constexpr EGLint kType = 0x3203, kTypeVulkan = 0x3450;
constexpr EGLint kDeviceType = 0x3209, kDeviceTypeSwiftShader = 0x3487;
constexpr EGLint kNativePlatform = 0x348F, kNativePlatformSurfaceless = 0x31DD;
constexpr EGLint kWebGlCompatibility = 0x33AC;

void* angle() {
  static void* const library = [] {
    const char* const folder = std::getenv("TEMBLOR_ANGLE");
    const std::string path = std::string(folder == nullptr ? "." : folder) + "/libEGL.so";
    void* const loaded = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (loaded == nullptr) {
      std::fprintf(stderr, "TEMBLOR_ANGLE: %s\n", dlerror());
      std::exit(1);
    }
    return loaded;
  }();
  return library;
}

// ANGLE's function of this name.
template <typename Function>
Function* find(const char* name) {
  return reinterpret_cast<Function*>(dlsym(angle(), name));
}
#define ANGLE(name) find<decltype(name)>(#name)

// Whatever platform was asked for.
EGLDisplay get_platform_display(EGLenum, void*, const EGLint*) {
  const EGLint attributes[] = {
      kType,   kTypeVulkan, kDeviceType, kDeviceTypeSwiftShader, kNativePlatform, kNativePlatformSurfaceless,
      EGL_NONE};
  return ANGLE(eglGetPlatformDisplayEXT)(kPlatformAngle, EGL_DEFAULT_DISPLAY, attributes);
}

}  // namespace

extern "C" {

__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
  if (std::string_view(name) == "eglGetPlatformDisplayEXT")
    return reinterpret_cast<__eglMustCastToProperFunctionPointerType>(&get_platform_display);
  return ANGLE(eglGetProcAddress)(name);
}

EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext shared,
                            const EGLint* attributes) {
  std::vector<EGLint> all;
  for (; *attributes != EGL_NONE; attributes += 2) all.insert(all.end(), {attributes[0], attributes[1]});
  all.insert(all.end(), {kWebGlCompatibility, EGL_TRUE, EGL_NONE});
  return ANGLE(eglCreateContext)(display, config, shared, all.data());
}

EGLBoolean eglInitialize(EGLDisplay display, EGLint* out_major, EGLint* out_minor) {
  return ANGLE(eglInitialize)(display, out_major, out_minor);
}
EGLBoolean eglBindAPI(EGLenum api) {
  return ANGLE(eglBindAPI)(api);
}
EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
  return ANGLE(eglMakeCurrent)(display, draw, read, context);
}
EGLContext eglGetCurrentContext() {
  return ANGLE(eglGetCurrentContext)();
}
EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
  return ANGLE(eglDestroyContext)(display, context);
}
EGLint eglGetError() {
  return ANGLE(eglGetError)();
}
}
