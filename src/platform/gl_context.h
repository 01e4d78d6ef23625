// The interface to an OpenGL context: what a renderer on the graphics card needs from the system. An
// implementation owns the connection to the driver; platform/egl/offscreen_context.h needs no display.
#pragma once

#include <string>

#include "base/result.h"

namespace temblor::platform {

class GlContext {
 public:
  virtual ~GlContext() = default;
  // Makes the context current on this thread. Functions of OpenGL act on the current context. Fails with kIo
  // if the context is lost.
  virtual base::Status make_current() = 0;
  // The address of a function by its name, such as "glClear"; null if the driver lacks it.
  virtual void* find_function(const char* name) const = 0;
};

// A context that draws into a window: framebuffer 0 is the window's.
class WindowGlContext : public GlContext {
 public:
  // Shows what was drawn into the window. With vsync, it may wait for the display.
  virtual void show() = 0;
  // Whether the driver draws on the CPU.
  virtual bool is_software() const = 0;
};

}  // namespace temblor::platform
