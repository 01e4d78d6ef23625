// The ways to bring a finished picture to the screen.
//
//   x11_presenter.h   picture --scale on the CPU--> memory shared with the X server --Present--> window
//   surface           picture --scale on the CPU--> surface of SDL --> window
//   renderer          picture --copy--> texture --scale by SDL's renderer (GPU)--> window
//
// The first two need no graphics driver. The renderer scales without CPU time. The surface has no vsync.
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
  // How pictures reach the window, and whether with vsync, for a person.
  virtual std::string describe() const = 0;
};

// Presents through the window's surface. Returns null if the display has none: Wayland with SDL 2.
std::unique_ptr<PicturePresenter> make_surface_presenter(SDL_Window* window);
// Presents through SDL's renderer. Returns null if there is none, or if it is a software renderer and
// `hardware_only` is set.
std::unique_ptr<PicturePresenter> make_renderer_presenter(SDL_Window* window, bool hardware_only);

}  // namespace temblor::platform::sdl2
