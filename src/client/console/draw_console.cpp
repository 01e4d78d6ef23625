// Draws the console. Units are the original's pixels, y down:
//
//   +------------------------------+ 0
//   | older output                 |   the topmost row may be cut off
//   | newest output                |
//   | ^   ^   ^   ^   ^   ^        |   only while scrolled back
//   | ]input line_                 |
//   |                Temblor 0.1.0 |   the picture's lower edge
//   +------------------------------+ bottom, which slides
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/console/console_canvas.h"
#include "client/console/console_ui.h"
#include "client/console/utf8.h"
#include "client/console/wrap_text.h"

namespace temblor::client {

namespace {

constexpr double kOpenHeight = 0.5;  // share of the frame, over a game

// The height of the edge below the input line. In the original 12 of the picture's 200 rows are an edge
// without text; the version needs at least a row of characters.
int bottom_edge(const ConsoleCanvas& canvas) {
  constexpr int kEdge = 12, kPictureHeight = 200;
  return std::max(kCharacterSide, canvas.height() * kEdge / kPictureHeight);
}

// Converts a cursor position in bytes to one in characters.
std::size_t count_glyphs_before(std::string_view text, std::size_t bytes) {
  return to_glyphs(text.substr(0, bytes)).size();
}

void draw_input(const ConsoleCanvas& canvas, std::string_view prompt, const EditLine& line, int y,
                double time_s) {
  const InputLineView shown = layout_input_line(
      prompt, to_glyphs(line.text()), count_glyphs_before(line.text(), line.cursor()), canvas.columns());
  canvas.draw_text(shown.glyphs, 0, y);
  canvas.draw_cursor(shown.cursor_column, y, time_s);
}

// Draws a row of bronze arrows, which says that there is newer output below.
void draw_more_below(const ConsoleCanvas& canvas, int y) {
  constexpr int kSpacing = 4;
  constexpr char kArrow = static_cast<char>('^' | 0x80);
  for (int column = 0; column < canvas.columns(); column += kSpacing)
    canvas.draw_text({&kArrow, 1}, column, y);
}

}  // namespace

// Moves the lower edge toward its place at constant speed. Without a game there is nothing to slide over.
void ConsoleUi::advance_slide(const ConsoleView& view) {
  constexpr double kOriginalHeight = 200;
  const double elapsed_s = std::max(0.0, view.time_s - time_s_);
  const double step = elapsed_s * view.settings.slide_speed / kOriginalHeight;
  const double target = is_open() ? kOpenHeight : 0;
  shown_ = shown_ < target ? std::min(shown_ + step, target) : std::max(shown_ - step, target);
  if (!view.game_runs) shown_ = 1;
  time_s_ = view.time_s;
  game_runs_ = view.game_runs;
  covers_frame_ = !view.game_runs;
}

std::string ConsoleUi::prompt() const {
  return search_ ? fmt::format("search \"{}\": ", to_glyphs(search_->text)) : "]";
}

void ConsoleUi::draw_page(const ConsoleCanvas& canvas, const ConsoleView& view) {
  const int bottom = static_cast<int>(std::lround(shown_ * canvas.height()));
  if (bottom <= 0) return;
  // The y of text rows above the edge, counted from 1.
  const auto row_y = [&](int row) { return bottom - bottom_edge(canvas) - row * kTextLine; };
  canvas.draw_background(bottom, view.game_runs ? view.settings.opacity : 1);
  canvas.draw_right_aligned_text(to_bronze_glyphs(view.version), bottom - kCharacterSide);
  draw_input(canvas, prompt(), line_, row_y(1), time_s_);

  int row = 2;
  if (!scrollback_.is_at_end()) draw_more_below(canvas, row_y(row++));
  // The topmost row may be cut off.
  const int rows = std::max(0, (row_y(row) + kTextLine - 1) / kTextLine + 1);
  scrollback_.collect_rows_upwards(log_, static_cast<std::size_t>(rows), rows_);
  for (const std::string_view text : rows_) canvas.draw_text(text, 0, row_y(row++));
}

// Draws the latest messages over the game, newest last, and returns the number of rows. Collects rows from
// the newest line upward, and stops at the first line that is too old.
int ConsoleUi::draw_notify(const ConsoleCanvas& canvas, const ConsoleSettings& settings) {
  const auto max_rows = static_cast<std::size_t>(std::max(settings.notify_rows, 0));
  rows_.clear();
  for (std::uint64_t line = log_.end_line(); line-- > std::max(notify_from_, log_.begin_line());) {
    if (rows_.size() >= max_rows || time_s_ - log_.line(line).time_s >= settings.notify_time_s) break;
    wrap_line(log_.line(line).text, canvas.columns(), line_rows_);
    rows_.insert(rows_.end(), line_rows_.rbegin(), line_rows_.rend());
  }
  rows_.resize(std::min(rows_.size(), max_rows));
  int y = 0;
  for (auto row = rows_.rbegin(); row != rows_.rend(); ++row, y += kTextLine) {
    if (!row->empty()) canvas.draw_row_background(y);
    canvas.draw_text(*row, 0, y);
  }
  return static_cast<int>(rows_.size());
}

void ConsoleUi::draw(const ConsoleView& view, int width, int height, render::DrawList& io_list) {
  advance_slide(view);
  const ConsoleCanvas canvas(view.pictures, view.settings, width, height, io_list);
  // Scrolling works on the page of the fully open console, so that a slide does not change the position. Two
  // rows are kept free: for the input line and for the arrows.
  const double page = (view.game_runs ? kOpenHeight : 1) * canvas.height();
  scrollback_.set_page(canvas.columns(), (static_cast<int>(page) - bottom_edge(canvas)) / kTextLine - 2);
  if (shown_ > 0) return draw_page(canvas, view);
  const int y = draw_notify(canvas, view.settings) * kTextLine;
  if (entry_ != Entry::kChat && entry_ != Entry::kTeamChat) return;
  canvas.draw_row_background(y);
  draw_input(canvas, entry_ == Entry::kTeamChat ? "say_team: " : "say: ", chat_, y, time_s_);
}

}  // namespace temblor::client
