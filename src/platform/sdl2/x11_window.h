// The X server's number of a window of SDL. It has its own source, because the headers of Xlib define common
// words as macros.
#pragma once

#include <cstdint>
#include <optional>

struct SDL_Window;

namespace temblor::platform::sdl2 {

// Returns nothing if the display is not an X server.
std::optional<std::uint32_t> find_x11_window(SDL_Window* window);

}  // namespace temblor::platform::sdl2
