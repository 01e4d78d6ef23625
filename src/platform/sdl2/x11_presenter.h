// Shows pictures in an X11 window by shared memory and the Present extension, with or without vsync.
//
//   picture --copy or scale--> one of two shared pixmaps --PresentPixmap--> window, at the next refresh
//             ^                                                                  |
//             '------ IdleNotify: the server no longer reads it -----------------'
//                     CompleteNotify: the picture is in the window
//
// With vsync, present() returns when the picture is in the window, not when the server has accepted it: the
// next frame then reads its input as late as possible. Method: Keith Packard, *The Present Extension* (X.Org,
// 2013). Needs a local X server; SDL's surface is the fallback.
#pragma once

#include <SDL.h>

#include <memory>

#include "platform/sdl2/presenters.h"

namespace temblor::platform::sdl2 {

// Returns null if the display is not an X server, or cannot do this (x11_display.h).
std::unique_ptr<PicturePresenter> make_x11_presenter(SDL_Window* window);

}  // namespace temblor::platform::sdl2
