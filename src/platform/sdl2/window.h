// A window by SDL2: X11, Wayland and what else it knows.
#pragma once

#include <memory>
#include <string>

#include "platform/window.h"

namespace temblor::platform::sdl2 {

// How pictures are handed over. kAuto: through the display's renderer where that is real hardware, which
// scales for nothing and waits for the screen; else through memory that the window shares, for a renderer in
// software would cost more than the frame.
enum class Presenter { kAuto, kSharedMemory, kRenderer };

// Fails where there is no display.
base::Result<std::unique_ptr<Window>> open_window(const std::string& title, const WindowSettings& settings,
                                                  Presenter presenter = Presenter::kAuto);

}  // namespace temblor::platform::sdl2
