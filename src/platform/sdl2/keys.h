// SDL's names of keys and buttons to ours.
#pragma once

#include <SDL.h>

#include "platform/key.h"

namespace temblor::platform::sdl2 {

// kNone for what nothing can be bound to.
Key key_of(SDL_Scancode scancode);
Key key_of_mouse_button(int button);
Key key_of(SDL_GameControllerButton button);

}  // namespace temblor::platform::sdl2
