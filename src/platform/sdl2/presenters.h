// The two ways from a finished picture to the screen.
#pragma once

#include <SDL.h>

#include <memory>
#include <string>

#include "platform/window.h"

namespace temblor::platform::sdl2 {

class PicturePresenter {
 public:
  virtual ~PicturePresenter() = default;
  virtual base::Status present(const Picture& picture, base::Jobs& jobs) = 0;
  virtual void set_vsync(bool vsync) = 0;
  virtual std::string describe() const = 0;
};

// Through the window's own surface; null where the display gives none, as Wayland by SDL 2.
std::unique_ptr<PicturePresenter> make_surface_presenter(SDL_Window* window);
// Through the display's renderer; null where it is missing, or is software and `hardware_only`.
std::unique_ptr<PicturePresenter> make_renderer_presenter(SDL_Window* window, bool hardware_only);

}  // namespace temblor::platform::sdl2
