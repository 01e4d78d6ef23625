#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace temblor::app {

// "\r\x1b[K": to the start of the line, which is then empty.
Progress::Progress(std::string what) : what_(std::move(what)), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::update(std::size_t done, std::size_t total) {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K{}: {} of {}", what_, done, total);
}

}  // namespace temblor::app
