#include "platform/sdl2/library.h"

#include <SDL.h>

#include <utility>

namespace temblor::platform::sdl2 {

base::Error sdl_error(const char* what) {
  return base::error(base::ErrorCode::kIo, "{}: {}", what, SDL_GetError());
}

base::Result<Subsystem> Subsystem::start(std::uint32_t flags) {
  SDL_SetMainReady();
  // The program handles Ctrl-C itself.
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
  if (SDL_InitSubSystem(flags) != 0) return sdl_error("SDL");
  return Subsystem(flags);
}

// A moved-from value has no flags and stops nothing.
Subsystem::Subsystem(Subsystem&& other) noexcept : flags_(std::exchange(other.flags_, 0)) {}

Subsystem& Subsystem::operator=(Subsystem&& other) noexcept {
  std::swap(flags_, other.flags_);
  return *this;
}

Subsystem::~Subsystem() {
  if (flags_ != 0) SDL_QuitSubSystem(flags_);
}

}  // namespace temblor::platform::sdl2
