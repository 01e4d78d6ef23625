// A progress line on standard error, rewritten in place. Prints nothing if standard error is not a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace temblor::app {

class Progress {
 public:
  // `what` names what is counted, such as "frames".
  explicit Progress(std::string what);
  // Erases the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, std::size_t total);

 private:
  std::string what_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Returns "frames: [####......] 40 of 100, 12 s left". The remaining time is extrapolated from `elapsed_s`
// and left out while `done` is 0.
std::string describe_progress(const std::string& what, std::size_t done, std::size_t total, double elapsed_s);

}  // namespace temblor::app
