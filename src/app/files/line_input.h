// Lines from standard input, without waiting for them. POSIX.
#pragma once

#include <string>
#include <vector>

namespace temblor::app {

class LineInput {
 public:
  static constexpr std::size_t kMaxLineChars = 4096;  // what is longer comes in pieces

  // Waits at most that long, less when something comes; the lines that are whole by then. The last one of
  // input that has ended need not have an end of its own.
  std::vector<std::string> wait(double at_most_s);
  bool has_ended() const { return has_ended_; }

 private:
  std::string partial_;
  bool has_ended_ = false;
};

}  // namespace temblor::app
