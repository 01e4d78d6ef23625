// One parallel_for for the whole program, over oneTBB or over plain std::thread (which the thread sanitizer
// understands, and the browser has). Results must not depend on which job runs where.
#pragma once

#include <cstddef>
#include <memory>

#include "base/function_ref.h"

namespace temblor::base {

// kOneTbb runs on as many cores as there are, whatever is asked; kStdThread starts what is asked.
enum class JobBackend { kOneTbb, kStdThread };

// A fixed number of workers. Not itself thread-safe: one parallel_for at a time.
class Jobs {
 public:
  // `threads` counts the caller: 1 runs everything in place and starts no thread. Without oneTBB in the
  // build, both back ends are std::thread.
  explicit Jobs(int threads, JobBackend backend = JobBackend::kOneTbb);
  ~Jobs();
  Jobs(Jobs&&) noexcept;
  Jobs& operator=(Jobs&&) noexcept;

  int threads() const { return threads_; }

  // Calls body(i) once for every i in [0, count), in any order, on any worker; returns when all are done.
  void parallel_for(std::size_t count, FunctionRef<void(std::size_t)> body);

  struct Pool;  // one of the back ends; private to the source file

 private:
  int threads_;
  std::unique_ptr<Pool> pool_;
};

}  // namespace temblor::base
