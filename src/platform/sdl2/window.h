// A window on a display of SDL2: X11, Wayland and others.
#pragma once

#include <memory>
#include <string>

#include "platform/window.h"

namespace temblor::platform::sdl2 {

// How pictures reach the window (presenters.h). kAuto uses the renderer if it is hardware, because it scales
// at no cost to us. Otherwise it uses shared memory: a software renderer would take more time than our frame.
enum class Presenter { kAuto, kSharedMemory, kRenderer };

// Opens a window. Fails if there is no display.
base::Result<std::unique_ptr<Window>> open_window(const std::string& title, const WindowSettings& settings,
                                                  Presenter presenter = Presenter::kAuto);

}  // namespace temblor::platform::sdl2
