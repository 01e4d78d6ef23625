// Defers Ctrl-C while there is work to save (POSIX).
#pragma once

#include <atomic>
#include <csignal>
#include <thread>

namespace temblor::app {

// While it exists, SIGINT, SIGTERM, and SIGHUP still end the program at once, except between defer() and
// stop_deferring(): there, the first one only sets a flag, and the second one ends the program.
//
// Signals are blocked in all threads, and a separate thread waits for them, so no code runs in signal
// handlers. Construct it before other threads start, because they inherit the signal mask. Only one may exist
// at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  void defer() { deferred_ = true; }
  void stop_deferring() { deferred_ = false; }
  // Returns whether a signal arrived while they were deferred.
  bool was_requested() const { return requested_; }

 private:
  void wait_for_signals(const std::stop_token& stop);

  // The signal mask to restore.
  sigset_t before_{};
  std::atomic<bool> deferred_{false}, requested_{false};
  std::jthread waiter_;
};

}  // namespace temblor::app
