// Reads lines from standard input with a timeout (POSIX), for the console of a dedicated server.
#pragma once

#include <string>
#include <vector>

namespace temblor::app {

class LineInput {
 public:
  // Longer lines are split.
  static constexpr std::size_t kMaxLineChars = 4096;

  // Waits up to `timeout_s` for input and returns the lines that are complete, without newlines. At the end
  // of input, a last line without a newline counts as complete; from then on it only waits.
  std::vector<std::string> wait(double timeout_s);
  bool has_ended() const { return has_ended_; }

 private:
  // The beginning of an incomplete line.
  std::string partial_;
  bool has_ended_ = false;
};

}  // namespace temblor::app
