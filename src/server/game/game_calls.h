// Calls of QuakeC functions. All of them go through this interface, which sets self, other and time as the
// original does. So physics needs no machine, and tests can replace QuakeC.
#pragma once

#include "base/result.h"
#include "vm/program.h"

namespace temblor::server {

class GameCalls {
 public:
  virtual ~GameCalls() = default;
  // Calls `function`, and restores the old self and other afterward. kNoFunction does nothing. After a QuakeC
  // error the game must end. `time_s` is what QuakeC reads as `time`; a think function gets its own due time.
  virtual base::Status call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                            double time_s) = 0;
};

}  // namespace temblor::server
