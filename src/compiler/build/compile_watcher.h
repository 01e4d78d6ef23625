// Who is told how far a compilation is.
#pragma once

#include <cstddef>

#include "base/bytes.h"

namespace temblor::compiler {

// As it is: nobody.
class CompileWatcher {
 public:
  virtual ~CompileWatcher() = default;
  // `name` lives as long as the program.
  virtual void begin_stage(const char* /*name*/) {}
  // Of the stage that began last; by one thread at a time. False: stop.
  virtual bool progress(std::size_t /*done*/, std::size_t /*total*/) { return true; }
  // Now and then while visibility is worked out: Build::visibility_state with what is done.
  virtual void save(base::Bytes /*visibility_state*/) {}
};

}  // namespace temblor::compiler
