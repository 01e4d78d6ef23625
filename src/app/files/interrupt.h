// Ctrl-C while something is worth saving. POSIX.
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace temblor::app {

// While it lives SIGINT and SIGTERM end the program at once, as ever, but between hold() and let_go() the
// first of them is only noted; a second one ends it. To be made before other threads are, because they
// inherit that signals come here; only one at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  void hold() { held_ = true; }
  void let_go() { held_ = false; }
  bool was_noted() const { return noted_; }

 private:
  void wait_for_signals(const std::stop_token& stop);

  sigset_t before_{};
  std::atomic<bool> held_{false}, noted_{false};
  std::jthread waiter_;
};

}  // namespace temblor::app
