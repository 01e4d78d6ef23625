#include "client/console/scrollback.h"

#include <algorithm>

#include "client/console/wrap_text.h"

namespace temblor::client {

namespace {

bool is_empty(const ConsoleLog& log) {
  return log.begin_line() == log.end_line();
}

}  // namespace

void Scrollback::set_page(int columns, int rows) {
  columns_ = std::max(columns, 1);
  page_rows_ = std::max(rows, 1);
}

// A page step keeps two rows of the last page visible.
int Scrollback::page_step() const {
  return std::max(1, page_rows_ - 2);
}

std::size_t Scrollback::count_line_rows(const ConsoleLog& log, std::uint64_t line) const {
  return count_rows(log.line(line).text, columns_);
}

Scrollback::Row Scrollback::last_row(const ConsoleLog& log) const {
  const std::uint64_t line = log.end_line() - 1;
  return {line, count_line_rows(log, line) - 1};
}

// Corrects a stored position that is out of date: its line may have been dropped, cleared, or replaced by a
// shorter one, and the number of columns may have changed.
Scrollback::Row Scrollback::lowest_row(const ConsoleLog& log) const {
  if (!lowest_ || lowest_->line >= log.end_line()) return last_row(log);
  if (lowest_->line < log.begin_line()) return {log.begin_line(), 0};
  return {lowest_->line, std::min(lowest_->row, count_line_rows(log, lowest_->line) - 1)};
}

// Steps line by line: from row `row` of a line, `row` + 1 steps up lead to the last row of the line before.
// Stops at the first row of the log.
Scrollback::Row Scrollback::step_up(const ConsoleLog& log, Row from, std::size_t rows) const {
  while (rows > from.row) {
    if (from.line == log.begin_line()) return {from.line, 0};
    rows -= from.row + 1;
    --from.line;
    from.row = count_line_rows(log, from.line) - 1;
  }
  return {from.line, from.row - rows};
}

// The mirror image of step_up(); stops at the last row of the log.
Scrollback::Row Scrollback::step_down(const ConsoleLog& log, Row from, std::size_t rows) const {
  for (;;) {
    const std::size_t below = count_line_rows(log, from.line) - 1 - from.row;
    if (rows <= below) return {from.line, from.row + rows};
    if (from.line + 1 == log.end_line()) return {from.line, from.row + below};
    rows -= below + 1;
    from = {from.line + 1, 0};
  }
}

// Limits the position so that the page stays full at the start of the log. Reaching the newest row ends
// scrolling back, so that new rows are followed again.
void Scrollback::scroll_to(const ConsoleLog& log, const Row& wanted) {
  const Row first_page = step_down(log, {log.begin_line(), 0}, static_cast<std::size_t>(page_rows_ - 1));
  const Row row = std::max(wanted, first_page);
  lowest_ = row < last_row(log) ? std::optional(row) : std::nullopt;
}

void Scrollback::scroll_up(const ConsoleLog& log, int rows) {
  if (!is_empty(log)) scroll_to(log, step_up(log, lowest_row(log), static_cast<std::size_t>(rows)));
}

void Scrollback::scroll_down(const ConsoleLog& log, int rows) {
  if (!is_empty(log)) scroll_to(log, step_down(log, lowest_row(log), static_cast<std::size_t>(rows)));
}

void Scrollback::scroll_to_start(const ConsoleLog& log) {
  if (!is_empty(log)) scroll_to(log, {log.begin_line(), 0});
}

void Scrollback::collect_rows_upwards(const ConsoleLog& log, std::size_t count,
                                      std::vector<std::string_view>& out_rows) {
  out_rows.clear();
  if (is_empty(log)) return scroll_to_end();
  if (lowest_) scroll_to(log, lowest_row(log));  // lines may have been dropped or rewrapped
  const Row from = lowest_row(log);
  for (std::uint64_t line = from.line;; --line) {
    wrap_line(log.line(line).text, columns_, line_rows_);
    std::size_t rows = line == from.line ? from.row + 1 : line_rows_.size();
    while (rows > 0 && out_rows.size() < count) out_rows.push_back(line_rows_[--rows]);
    if (line == log.begin_line() || out_rows.size() == count) return;
  }
}

}  // namespace temblor::client
