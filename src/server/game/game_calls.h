// The door into QuakeC: every call of a game function goes through here, with self, other and time set as the
// original has them. Physics and the rest of the server know no machine.
#pragma once

#include "base/result.h"
#include "vm/program.h"

namespace temblor::server {

class GameCalls {
 public:
  virtual ~GameCalls() = default;
  // Calls `function` of the program with these; kNoFunction does nothing. The old self and other come back
  // afterwards. An error is the program's: the game has to end.
  virtual base::Status call(vm::FunctionIndex function, vm::EntityIndex self, vm::EntityIndex other,
                            double time_s) = 0;
};

}  // namespace temblor::server
