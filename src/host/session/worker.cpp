#include "host/session/worker.h"

#include <condition_variable>
#include <mutex>
#include <thread>

#include "base/check.h"

namespace temblor::host {

struct Worker::State {
  std::mutex mutex;
  std::condition_variable changed;
  std::function<void()> work;  // empty: no job
  bool ends = false;
  std::thread thread;

  // The thread's loop. The mutex is free while a job runs, so that wait() can sleep on it. A job that was
  // begun is still run after `ends` is set.
  void run() {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return work != nullptr || ends; });
      if (work == nullptr) return;
      lock.unlock();
      work();
      lock.lock();
      work = nullptr;
      changed.notify_all();
    }
  }
};

Worker::Worker() : state_(std::make_unique<State>()) {
  state_->thread = std::thread([state = state_.get()] { state->run(); });
}

Worker::~Worker() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->ends = true;
  }
  state_->changed.notify_all();
  state_->thread.join();
}

void Worker::begin(std::function<void()> work) {
  CHECK(work != nullptr);
  {
    const std::lock_guard lock(state_->mutex);
    CHECK(state_->work == nullptr, "the worker is busy");
    state_->work = std::move(work);
  }
  state_->changed.notify_all();
}

void Worker::wait() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return state_->work == nullptr; });
}

}  // namespace temblor::host
