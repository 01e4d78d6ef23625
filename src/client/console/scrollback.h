// The visible part of the console's log: which rows are shown, and scrolling.
//
// Rows are log lines wrapped to a number of columns. Nothing is stored per row: wrapping is repeated for the
// rows on the page, so a change of the window's size costs nothing and the log may be long. The position is
// stored as a log line and a row within it. While scrolled back, the view stays on its rows as new ones are
// printed.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "client/console/console_log.h"

namespace temblor::client {

// Positions refer to a log that every call must pass again; it must be the same log each time.
class Scrollback {
 public:
  // Sets the page size in characters; values below 1 count as 1. The cost of all functions depends on the
  // page, not on the length of the log.
  void set_page(int columns, int rows);

  // Scroll by rows, or by a page less two rows, within the log. An empty log cannot be scrolled.
  void scroll_up(const ConsoleLog& log, int rows);
  void scroll_down(const ConsoleLog& log, int rows);
  void page_up(const ConsoleLog& log) { scroll_up(log, page_step()); }
  void page_down(const ConsoleLog& log) { scroll_down(log, page_step()); }
  void scroll_to_start(const ConsoleLog& log);
  void scroll_to_end() { lowest_.reset(); }
  // Whether the view is at the newest row.
  bool is_at_end() const { return !lowest_; }

  // The visible rows from the lowest one upward, at most `count`. The views refer to the log and are valid
  // until something is printed.
  void collect_rows_upwards(const ConsoleLog& log, std::size_t count,
                            std::vector<std::string_view>& out_rows);

 private:
  struct Row {
    std::uint64_t line = 0;
    // Row within the wrapped line, from 0.
    std::size_t row = 0;
    auto operator<=>(const Row&) const = default;
  };
  int page_step() const;
  std::size_t count_line_rows(const ConsoleLog& log, std::uint64_t line) const;
  Row last_row(const ConsoleLog& log) const;
  // The lowest visible row. The log must not be empty.
  Row lowest_row(const ConsoleLog& log) const;
  Row step_up(const ConsoleLog& log, Row from, std::size_t rows) const;
  Row step_down(const ConsoleLog& log, Row from, std::size_t rows) const;
  void scroll_to(const ConsoleLog& log, const Row& wanted);

  int columns_ = 1, page_rows_ = 1;
  // The lowest visible row; nothing while the view follows the newest row.
  std::optional<Row> lowest_;
  std::vector<std::string_view> line_rows_;
};

}  // namespace temblor::client
