#include "client/hud/center_text.h"

#include <algorithm>

namespace temblor::client {

namespace {

// The 320 pixels of the original's screen.
constexpr std::size_t kLineChars = 40;

// Removes the first line and returns it. A line is at most kLineChars long.
std::string_view take_line(std::string_view& io_text) {
  const std::size_t end = std::min(io_text.find('\n'), io_text.size());
  const std::string_view line = io_text.substr(0, std::min(end, kLineChars));
  // A line end right after a full line belongs to it and is not an empty line.
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
  // Like stock Quake, up to four lines start at 35 % of the frame's height, more at row 48 of the 320 x 200
  // screen.
  constexpr int kShortLines = 4, kLongY = 48;
  constexpr double kShortTop = 0.35;  // share of the frame's height
  const bool is_short = count_lines(text) <= kShortLines;
  const Panel place = is_short ? panel.with_top(static_cast<int>(panel.frame_height_px() * kShortTop))
                               : panel.in_middle(kScreenHeight);
  for (int y = is_short ? 0 : kLongY; !text.empty(); y += kCharacterSide) {
    const std::string_view line = take_line(text);
    place.draw_text(line.substr(0, letters),
                    (kScreenWidth - static_cast<int>(line.size()) * kCharacterSide) / 2, y);
    letters -= std::min(letters, line.size());
  }
}

std::size_t count_written_letters(double seconds, double letters_per_second) {
  constexpr double kMaxSeconds = 1e6;
  return static_cast<std::size_t>(std::clamp(seconds, 0.0, kMaxSeconds) * letters_per_second);
}

}  // namespace temblor::client
