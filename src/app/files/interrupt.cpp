#include "app/files/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <ctime>

namespace temblor::app {
namespace {

// Shells report the end by a signal as 128 plus its number.
constexpr int kSignalExitBase = 128;

// Returns the signals that end the program, except those that are ignored, for example because of nohup.
sigset_t list_ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t signals = list_ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, &before_);
  waiter_ = std::jthread([this](const std::stop_token& stop) { wait_for_signals(stop); });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

// Waits in short steps, so that the destructor need not wait long. _exit() skips destructors, which other
// threads may still need.
void Interrupt::wait_for_signals(const std::stop_token& stop) {
  const sigset_t signals = list_ending_signals();
  const timespec at_most{0, 50'000'000};
  while (!stop.stop_requested()) {
    const int signal = sigtimedwait(&signals, nullptr, &at_most);
    if (signal < 0) continue;
    if (!deferred_ || requested_) _exit(kSignalExitBase + signal);
    requested_ = true;
  }
}

}  // namespace temblor::app
