#include "client/hud/center_text.h"

#include <algorithm>

namespace temblor::client {

namespace {

constexpr std::size_t kLineChars = 40;

// Takes the first line off.
std::string_view take_line(std::string_view& io_text) {
  const std::size_t end = std::min(io_text.find('\n'), io_text.size());
  const std::string_view line = io_text.substr(0, std::min(end, kLineChars));
  // A line end that follows a full line is its own, not an empty line.
  const std::size_t taken = end <= kLineChars ? end + 1 : kLineChars;
  io_text.remove_prefix(std::min(taken, io_text.size()));
  return line;
}

int count_lines(std::string_view text) {
  int lines = 0;
  for (; !text.empty(); ++lines) take_line(text);
  return lines;
}

}  // namespace

void draw_center_text(const Panel& panel, std::string_view text, std::size_t letters) {
  constexpr int kShortLines = 4, kLongY = 48;
  constexpr double kShortTop = 0.35;  // of the frame's height
  const bool is_short = count_lines(text) <= kShortLines;
  const Panel place = is_short ? panel.with_top(static_cast<int>(panel.frame_height_px() * kShortTop))
                               : panel.in_middle(kScreenHeight);
  for (int y = is_short ? 0 : kLongY; !text.empty(); y += kCharacterSide) {
    const std::string_view line = take_line(text);
    place.text(line.substr(0, letters), (kScreenWidth - static_cast<int>(line.size()) * kCharacterSide) / 2,
               y);
    letters -= std::min(letters, line.size());
  }
}

std::size_t letters_written(double seconds) {
  constexpr double kLettersASecond = 8, kMaxSeconds = 1e6;
  return static_cast<std::size_t>(std::clamp(seconds, 0.0, kMaxSeconds) * kLettersASecond);
}

}  // namespace temblor::client
