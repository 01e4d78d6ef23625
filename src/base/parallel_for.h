// The parallel_for of the whole program. All work on several threads is a loop over independent indices, so
// results must not depend on the thread that runs an index, nor on the number of threads.
//
// Two back ends: oneTBB, and plain std::thread for the thread sanitizer, which cannot see into oneTBB, and
// for the browser. With one thread, neither is used and the loop runs on the caller.
#pragma once

#include <cstddef>
#include <memory>

#include "base/function_ref.h"

namespace temblor::base {

// kOneTbb never uses more threads than cores; kStdThread starts exactly as many threads as requested.
enum class JobBackend { kOneTbb, kStdThread };

// A fixed number of workers that sleep between calls. Not thread-safe itself: one parallel_for at a time.
class Jobs {
 public:
  // `threads` includes the caller: 1 starts no thread. In builds without oneTBB, both back ends use
  // std::thread.
  explicit Jobs(int threads, JobBackend backend = JobBackend::kOneTbb);
  ~Jobs();
  Jobs(Jobs&&) noexcept;
  Jobs& operator=(Jobs&&) noexcept;

  int threads() const { return threads_; }

  // Calls body(i) once for every i in [0, count), in any order, on any worker; returns when all are done. The
  // caller works too. `body` must not throw, and must not call parallel_for() of the same object.
  void parallel_for(std::size_t count, FunctionRef<void(std::size_t)> body);

  struct Pool;  // one of the back ends; private to the source file

 private:
  int threads_;
  std::unique_ptr<Pool> pool_;
};

}  // namespace temblor::base
