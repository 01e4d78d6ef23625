// SDL's subsystems, kept up while somebody needs them.
#pragma once

#include <cstdint>

#include "base/result.h"

namespace temblor::platform::sdl2 {

class Subsystem {
 public:
  // SDL_INIT_VIDEO and so on. Any number of them may be kept at a time.
  static base::Result<Subsystem> start(std::uint32_t flags);
  Subsystem(Subsystem&& other) noexcept;
  Subsystem& operator=(Subsystem&& other) noexcept;
  ~Subsystem();

 private:
  explicit Subsystem(std::uint32_t flags) : flags_(flags) {}
  std::uint32_t flags_;
};

// kIo, with SDL's own reason.
base::Error sdl_error(const char* what);

}  // namespace temblor::platform::sdl2
