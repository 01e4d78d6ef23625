#include "app/files/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <utility>

namespace temblor::app {
namespace {

std::string describe_time_left(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  return fmt::format("{} min {:02} s", whole / 60, whole % 60);
}

}  // namespace

// The time left assumes that the rest is as fast as what is done.
std::string describe_progress(const std::string& what, std::size_t done, std::size_t total,
                              double elapsed_s) {
  constexpr std::size_t kBarChars = 20;
  const std::size_t filled = total == 0 ? kBarChars : done * kBarChars / total;
  std::string text = fmt::format("{}: [{}{}] {} of {}", what, std::string(filled, '#'),
                                 std::string(kBarChars - filled, '.'), done, total);
  if (done > 0) {
    const double left_s = elapsed_s * static_cast<double>(total - done) / static_cast<double>(done);
    text += fmt::format(", {} left", describe_time_left(left_s));
  }
  return text;
}

// "\r\x1b[K" moves to the start of the line and clears it.
Progress::Progress(std::string what) : what_(std::move(what)), on_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (on_terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::update(std::size_t done, std::size_t total) {
  if (!on_terminal_) return;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
  fmt::print(stderr, "\r\x1b[K{}", describe_progress(what_, done, total, elapsed.count()));
}

}  // namespace temblor::app
