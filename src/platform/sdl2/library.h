// The lifetime of SDL's subsystems (video, audio, gamepads) as values. SDL counts how often each was started
// and stops it after the last one.
#pragma once

#include <cstdint>

#include "base/result.h"

namespace temblor::platform::sdl2 {

// Keeps the subsystems of `flags` running while it lives.
class Subsystem {
 public:
  // Starts subsystems: SDL_INIT_VIDEO and so on, combined by `|`. Fails with kIo and SDL's reason.
  static base::Result<Subsystem> start(std::uint32_t flags);
  Subsystem(Subsystem&& other) noexcept;
  Subsystem& operator=(Subsystem&& other) noexcept;
  ~Subsystem();

 private:
  explicit Subsystem(std::uint32_t flags) : flags_(flags) {}
  std::uint32_t flags_;
};

// Makes a kIo error from SDL's last error. `what` is the operation that failed.
base::Error sdl_error(const char* what);

}  // namespace temblor::platform::sdl2
