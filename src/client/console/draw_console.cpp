// ConsoleUi::draw. In the original's pixels from the console's bottom edge up: the lower edge of the picture
// behind it, with the version at its right, the line that is typed, then what was printed, newest lowest.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "client/console/console_canvas.h"
#include "client/console/console_ui.h"
#include "client/console/utf8.h"
#include "client/console/wrap_text.h"

namespace temblor::client {

namespace {

constexpr double kOpenHeight = 0.5;  // of the frame, over a game

// The original's picture has an edge of 12 of its 200 rows, which nothing is read on.
int bottom_edge(const ConsoleCanvas& canvas) {
  constexpr int kEdge = 12, kPictureHeight = 200;
  return std::max(kCharacterSide, canvas.height() * kEdge / kPictureHeight);
}

// As many characters as the first `bytes` bytes are.
std::size_t glyphs_before(std::string_view text, std::size_t bytes) {
  return to_glyphs(text.substr(0, bytes)).size();
}

void draw_input(const ConsoleCanvas& canvas, std::string_view prompt, const EditLine& line, int y,
                double time_s) {
  const ShownInput shown =
      show_input(prompt, to_glyphs(line.text()), glyphs_before(line.text(), line.cursor()), canvas.columns());
  canvas.text(shown.glyphs, 0, y);
  canvas.cursor(shown.cursor_column, y, time_s);
}

// Arrows all along a row: there is more below.
void draw_more_below(const ConsoleCanvas& canvas, int y) {
  constexpr int kSpacing = 4;
  constexpr char kArrow = static_cast<char>('^' | 0x80);
  for (int column = 0; column < canvas.columns(); column += kSpacing) canvas.text({&kArrow, 1}, column, y);
}

}  // namespace

void ConsoleUi::slide(const ConsoleView& view) {
  constexpr double kOriginalHeight = 200;
  const double passed_s = std::max(0.0, view.time_s - time_s_);
  const double step = passed_s * view.settings.slide_speed / kOriginalHeight;
  const double wanted = is_open() ? kOpenHeight : 0;
  shown_ = shown_ < wanted ? std::min(shown_ + step, wanted) : std::max(shown_ - step, wanted);
  if (!view.game_runs) shown_ = 1;
  time_s_ = view.time_s;
  game_runs_ = view.game_runs;
  covers_frame_ = !view.game_runs;
}

std::string ConsoleUi::prompt() const {
  return search_ ? fmt::format("find \"{}\": ", to_glyphs(search_->text)) : "]";
}

void ConsoleUi::draw_page(const ConsoleCanvas& canvas, const ConsoleView& view) {
  const int bottom = static_cast<int>(std::lround(shown_ * canvas.height()));
  if (bottom <= 0) return;
  // Rows of text above the edge, from 1.
  const auto row_y = [&](int row) { return bottom - bottom_edge(canvas) - row * kCharacterSide; };
  canvas.background(bottom, view.game_runs ? view.settings.opacity : 1);
  canvas.text_at_right(to_bronze_glyphs(view.version), bottom - kCharacterSide);
  draw_input(canvas, prompt(), line_, row_y(1), time_s_);

  int row = 2;
  if (!scrollback_.is_at_end()) draw_more_below(canvas, row_y(row++));
  // The highest may be cut off.
  const int rows = std::max(0, (row_y(row) + kCharacterSide - 1) / kCharacterSide + 1);
  scrollback_.rows_upwards(log_, static_cast<std::size_t>(rows), rows_);
  for (const std::string_view text : rows_) canvas.text(text, 0, row_y(row++));
}

// Rows of the last lines, newest last. Returns how many there are.
int ConsoleUi::draw_notify(const ConsoleCanvas& canvas, const ConsoleSettings& settings) {
  const auto most = static_cast<std::size_t>(std::max(settings.notify_rows, 0));
  rows_.clear();
  for (std::uint64_t line = log_.end_line(); line-- > std::max(notify_from_, log_.begin_line());) {
    if (rows_.size() >= most || time_s_ - log_.line(line).time_s >= settings.notify_time_s) break;
    wrap_line(log_.line(line).text, canvas.columns(), line_rows_);
    rows_.insert(rows_.end(), line_rows_.rbegin(), line_rows_.rend());
  }
  rows_.resize(std::min(rows_.size(), most));
  int y = 0;
  for (auto row = rows_.rbegin(); row != rows_.rend(); ++row, y += kCharacterSide) {
    if (!row->empty()) canvas.row_background(y);
    canvas.text(*row, 0, y);
  }
  return static_cast<int>(rows_.size());
}

void ConsoleUi::draw(const ConsoleView& view, int width, int height, render::DrawList& io_list) {
  slide(view);
  const ConsoleCanvas canvas(view.pictures, view.settings, width, height, io_list);
  // Whole rows, below which the arrows have room.
  const double page = (view.game_runs ? kOpenHeight : 1) * canvas.height();
  scrollback_.set_page(canvas.columns(), (static_cast<int>(page) - bottom_edge(canvas)) / kCharacterSide - 2);
  if (shown_ > 0) return draw_page(canvas, view);
  const int y = draw_notify(canvas, view.settings) * kCharacterSide;
  if (entry_ != Entry::kChat && entry_ != Entry::kTeamChat) return;
  canvas.row_background(y);
  draw_input(canvas, entry_ == Entry::kTeamChat ? "say_team: " : "say: ", chat_, y, time_s_);
}

}  // namespace temblor::client
