#include "app/files/line_input.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

namespace temblor::app {

// After the end of input, as with `< /dev/null`, poll() would return at once, so sleep instead.
std::vector<std::string> LineInput::wait(double timeout_s) {
  if (has_ended_) {
    std::this_thread::sleep_for(std::chrono::duration<double>(timeout_s));
    return {};
  }
  // Round up: a wait that ends too early would only be repeated.
  pollfd input{STDIN_FILENO, POLLIN, 0};
  const auto whole_ms = static_cast<int>(std::ceil(timeout_s * 1000));
  if (poll(&input, 1, whole_ms) <= 0 || input.revents == 0) return {};

  std::array<char, 1024> bytes;
  const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count <= 0) has_ended_ = true;
  std::vector<std::string> lines;
  for (ssize_t i = 0; i < count; ++i) {
    const char c = bytes[static_cast<std::size_t>(i)];
    if (c != '\n') partial_ += c;
    if (c == '\n' || partial_.size() >= kMaxLineChars) lines.push_back(std::exchange(partial_, {}));
  }
  if (has_ended_ && !partial_.empty()) lines.push_back(std::exchange(partial_, {}));
  return lines;
}

}  // namespace temblor::app
