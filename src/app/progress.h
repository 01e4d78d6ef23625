// How far long work has got: one line on standard error that rewrites itself, only where that is a terminal.
#pragma once

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
};

}  // namespace temblor::app
