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

}  // namespace temblor::platform
