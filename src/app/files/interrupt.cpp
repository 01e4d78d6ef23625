#include "app/files/interrupt.h"

#include <pthread.h>
#include <unistd.h>

#include <ctime>

namespace temblor::app {
namespace {

constexpr int kExitOfSignal = 128;  // and the signal's number, as shells count

sigset_t ending_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals, signal);  // nohup and the like stay in force
  }
  return signals;
}

}  // namespace

Interrupt::Interrupt() {
  const sigset_t signals = ending_signals();
  pthread_sigmask(SIG_BLOCK, &signals, &before_);
  waiter_ = std::jthread([this](const std::stop_token& stop) { wait_for_signals(stop); });
}

Interrupt::~Interrupt() {
  waiter_.request_stop();
  waiter_.join();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void Interrupt::wait_for_signals(const std::stop_token& stop) {
  const sigset_t signals = ending_signals();
  const timespec at_most{0, 50'000'000};
  while (!stop.stop_requested()) {
    const int signal = sigtimedwait(&signals, nullptr, &at_most);
    if (signal < 0) continue;
    if (!held_ || noted_) _exit(kExitOfSignal + signal);
    noted_ = true;
  }
}

}  // namespace temblor::app
