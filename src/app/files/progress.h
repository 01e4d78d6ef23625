// How far long work has got, and how long it still takes: one line on standard error that rewrites itself,
// only where that is a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace temblor::app {

class Progress {
 public:
  // `what` stands in front of the count.
  explicit Progress(std::string what);
  ~Progress();  // takes the line away
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(std::size_t done, std::size_t total);

 private:
  std::string what_;
  bool on_terminal_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// "frames: [####......] 40 of 100, 12 s left"; without the time as long as nothing is done.
std::string describe_progress(const std::string& what, std::size_t done, std::size_t total, double elapsed_s);

}  // namespace temblor::app
