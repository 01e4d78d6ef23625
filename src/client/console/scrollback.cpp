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

// Two rows of the page before stay in sight.
int Scrollback::page_step() const {
  return std::max(1, page_rows_ - 2);
}

std::size_t Scrollback::rows_of(const ConsoleLog& log, std::uint64_t line) const {
  return count_rows(log.line(line).text, columns_);
}

Scrollback::Row Scrollback::last(const ConsoleLog& log) const {
  const std::uint64_t line = log.end_line() - 1;
  return {line, rows_of(log, line) - 1};
}

Scrollback::Row Scrollback::lowest(const ConsoleLog& log) const {
  if (!lowest_ || lowest_->line >= log.end_line()) return last(log);
  if (lowest_->line < log.begin_line()) return {log.begin_line(), 0};
  return {lowest_->line, std::min(lowest_->row, rows_of(log, lowest_->line) - 1)};
}

Scrollback::Row Scrollback::moved_up(const ConsoleLog& log, Row from, std::size_t rows) const {
  while (rows > from.row) {
    if (from.line == log.begin_line()) return {from.line, 0};
    rows -= from.row + 1;
    --from.line;
    from.row = rows_of(log, from.line) - 1;
  }
  return {from.line, from.row - rows};
}

Scrollback::Row Scrollback::moved_down(const ConsoleLog& log, Row from, std::size_t rows) const {
  for (;;) {
    const std::size_t below = rows_of(log, from.line) - 1 - from.row;
    if (rows <= below) return {from.line, from.row + rows};
    if (from.line + 1 == log.end_line()) return {from.line, from.row + below};
    rows -= below + 1;
    from = {from.line + 1, 0};
  }
}

// Not so far up that the page would not be full.
void Scrollback::show(const ConsoleLog& log, const Row& wanted) {
  const Row first_page = moved_down(log, {log.begin_line(), 0}, static_cast<std::size_t>(page_rows_ - 1));
  const Row row = std::max(wanted, first_page);
  lowest_ = row < last(log) ? std::optional(row) : std::nullopt;
}

void Scrollback::up(const ConsoleLog& log, int rows) {
  if (!is_empty(log)) show(log, moved_up(log, lowest(log), static_cast<std::size_t>(rows)));
}

void Scrollback::down(const ConsoleLog& log, int rows) {
  if (!is_empty(log)) show(log, moved_down(log, lowest(log), static_cast<std::size_t>(rows)));
}

void Scrollback::to_begin(const ConsoleLog& log) {
  if (!is_empty(log)) show(log, {log.begin_line(), 0});
}

void Scrollback::rows_upwards(const ConsoleLog& log, std::size_t count,
                              std::vector<std::string_view>& out_rows) {
  out_rows.clear();
  if (is_empty(log)) return to_end();
  if (lowest_) show(log, lowest(log));  // as lines were forgotten, or wrapped anew
  const Row from = lowest(log);
  for (std::uint64_t line = from.line;; --line) {
    wrap_line(log.line(line).text, columns_, line_rows_);
    std::size_t rows = line == from.line ? from.row + 1 : line_rows_.size();
    while (rows > 0 && out_rows.size() < count) out_rows.push_back(line_rows_[--rows]);
    if (line == log.begin_line() || out_rows.size() == count) return;
  }
}

}  // namespace temblor::client
