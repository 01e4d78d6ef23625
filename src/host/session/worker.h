// A thread that runs one job at a time in parallel with its owner: server ticks, while a frame is drawn.
//
// begin() and wait() must be called from one thread. They order memory: the job sees everything that was
// written before begin(), and its own writes are visible after wait().
#pragma once

#include <functional>
#include <memory>

namespace temblor::host {

class Worker {
 public:
  Worker();
  // Finishes the job, if one is running.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // Starts a job. wait() must have been called for the previous one.
  void begin(std::function<void()> work);
  // Waits until the job is done; returns at once if none was started.
  void wait();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::host
