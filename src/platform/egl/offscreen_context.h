// An OpenGL ES 3 context without a window or a display, for pictures, films, and tests. EGL is loaded when
// the first context is made, so the program also starts on machines without graphics drivers.
#pragma once

#include <memory>

#include "base/result.h"
#include "platform/gl_context.h"

namespace temblor::platform::egl {

// Fails with kUnsupported, and one line for a person, if there is no EGL, or if its driver offers no context
// of OpenGL ES 3.0 without a surface.
base::Result<std::unique_ptr<GlContext>> make_offscreen_context();

}  // namespace temblor::platform::egl
