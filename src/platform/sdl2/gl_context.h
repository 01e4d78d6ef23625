// A context of OpenGL for a window of SDL, which must have the flag SDL_WINDOW_OPENGL.
#pragma once

#include <SDL.h>

#include <memory>
#include <string>

#include "platform/gl_context.h"

namespace temblor::platform::sdl2 {

// A window, and how its context shows pictures. It belongs to the owner of the window.
struct GlWindow {
  SDL_Window* window;
  bool vsync = true;
};

// Current on the calling thread. `gl_window` must outlive it; a change of its vsync counts from the next
// picture on. Fails with kUnsupported if there is no OpenGL 3.3 and no OpenGL ES 3.0.
base::Result<std::unique_ptr<WindowGlContext>> make_gl_context(const GlWindow& gl_window);

// Whether the driver of the current context draws on the CPU.
bool has_software_driver();

// How pictures reach the window, and whether with vsync, for a person.
std::string describe_gl(const GlWindow& gl_window);

}  // namespace temblor::platform::sdl2
