#include "client/hud/center_text.h"

#include <algorithm>

namespace temblor::client {

namespace {

// The 320 pixels of the original's screen.
constexpr std::size_t kLineChars = 40;

std::size_t count_columns(const Panel& panel) {
  const int fitting = panel.frame_width_px() / (panel.scale() * kCharacterSide);
  return std::clamp<std::size_t>(static_cast<std::size_t>(std::max(fitting, 1)), 1, kLineChars);
}

// Where to break a line that is longer than `columns`: after the last word that fits. Full lines of 40
// characters are broken anywhere, like those of stock Quake.
std::size_t find_break(std::string_view line, std::size_t columns) {
  if (columns == kLineChars) return columns;
  const std::size_t space = line.rfind(' ', columns);
  return space == std::string_view::npos || space == 0 ? columns : space;
}

// Removes the first line and returns it.
std::string_view take_line(std::string_view& io_text, std::size_t columns) {
  const std::string_view whole = io_text.substr(0, io_text.find('\n'));
  if (whole.size() <= columns) {
    // A line end right after a full line belongs to it and is not an empty line.
    io_text.remove_prefix(std::min(whole.size() + 1, io_text.size()));
    return whole;
  }
  const std::string_view line = whole.substr(0, find_break(whole, columns));
  io_text.remove_prefix(line.size());
  if (columns < kLineChars && io_text.starts_with(' ')) io_text.remove_prefix(1);
  return line;
}

}  // namespace

int count_text_lines(const Panel& panel, std::string_view text) {
  const std::size_t columns = count_columns(panel);
  int lines = 0;
  for (; !text.empty(); ++lines) take_line(text, columns);
  return lines;
}

void draw_text_lines(const Panel& panel, std::string_view text, int line_height, std::size_t letters) {
  const std::size_t columns = count_columns(panel);
  for (int y = 0; !text.empty(); y += line_height) {
    const std::string_view line = take_line(text, columns);
    panel.draw_text(line.substr(0, letters),
                    (kScreenWidth - static_cast<int>(line.size()) * kCharacterSide) / 2, y);
    letters -= std::min(letters, line.size());
  }
}

void draw_center_text(const Panel& panel, std::string_view text, std::size_t letters, int min_top_px) {
  // Like stock Quake, up to four lines start at 35 % of the frame's height, more at row 48 of the 320 x 200
  // screen. Large text that would leave the frame starts further up.
  constexpr int kShortLines = 4, kLongY = 48;
  constexpr double kShortTop = 0.35;  // share of the frame's height
  const int lines = count_text_lines(panel, text);
  const int height = panel.frame_height_px(), scale = panel.scale();
  const int top = lines <= kShortLines ? static_cast<int>(height * kShortTop)
                                       : (height - kScreenHeight * scale) / 2 + kLongY * scale;
  const int last_top = std::max(0, height - lines * kCharacterSide * scale);
  draw_text_lines(panel.with_top(std::min(std::max(top, min_top_px), last_top)), text, kCharacterSide,
                  letters);
}

std::size_t count_written_letters(double seconds, double letters_per_second) {
  constexpr double kMaxSeconds = 1e6;
  return static_cast<std::size_t>(std::clamp(seconds, 0.0, kMaxSeconds) * letters_per_second);
}

}  // namespace temblor::client
