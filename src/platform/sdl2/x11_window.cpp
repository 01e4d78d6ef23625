#include "platform/sdl2/x11_window.h"

#include <SDL_syswm.h>

namespace temblor::platform::sdl2 {

std::optional<std::uint32_t> find_x11_window(SDL_Window* window) {
#ifdef SDL_VIDEO_DRIVER_X11
  SDL_SysWMinfo info;
  SDL_VERSION(&info.version);
  if (SDL_GetWindowWMInfo(window, &info) == SDL_TRUE && info.subsystem == SDL_SYSWM_X11)
    return static_cast<std::uint32_t>(info.info.x11.window);
#endif
  return std::nullopt;
}

}  // namespace temblor::platform::sdl2
