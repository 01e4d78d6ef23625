// One thread that does one thing at a time beside its owner: the game's tick while the picture is drawn.
#pragma once

#include <functional>
#include <memory>

namespace temblor::host {

class Worker {
 public:
  Worker();
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  // What was begun before must have been waited for.
  void begin(std::function<void()> work);
  // Until it is done; at once where nothing was begun.
  void wait();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace temblor::host
