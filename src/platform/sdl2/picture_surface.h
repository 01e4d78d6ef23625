// Draws a finished picture into a surface of SDL that has the window's size.
#pragma once

#include <SDL.h>

#include <memory>

#include "platform/window.h"

namespace temblor::platform::sdl2 {

struct FreeSurface {
  void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
};
using Surface = std::unique_ptr<SDL_Surface, FreeSurface>;

// Makes a surface of 0xRRGGBB pixels in rows without padding. It does not own the pixels.
Surface wrap_pixels(std::uint32_t* pixels, PixelSize size);

// Copies the picture into the surface, or stretches it if the sizes differ. The jobs share the work of
// copying.
base::Status draw_picture(const Picture& picture, base::Jobs& jobs, SDL_Surface& io_surface);

}  // namespace temblor::platform::sdl2
