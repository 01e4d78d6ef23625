// Translates SDL's key and button codes to ours.
#pragma once

#include <SDL.h>

#include "platform/key.h"

namespace temblor::platform::sdl2 {

// All return kNone for codes that commands cannot be bound to.
Key find_key(SDL_Scancode scancode);
Key find_mouse_key(int button);
Key find_key(SDL_GameControllerButton button);

}  // namespace temblor::platform::sdl2
