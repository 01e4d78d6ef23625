// Which rows of the log are to be seen. Rows are those of its lines, wrapped at a number of columns; going
// back, the rows that are shown stay where they are while others are printed.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "client/console/console_log.h"

namespace temblor::client {

class Scrollback {
 public:
  // What the page holds, each 1 or more. The work below is a page's, whatever the log's length.
  void set_page(int columns, int rows);

  void up(const ConsoleLog& log, int rows);
  void down(const ConsoleLog& log, int rows);
  void page_up(const ConsoleLog& log) { up(log, page_step()); }
  void page_down(const ConsoleLog& log) { down(log, page_step()); }
  void to_begin(const ConsoleLog& log);
  void to_end() { lowest_.reset(); }
  // There is nothing below what is shown.
  bool is_at_end() const { return !lowest_; }

  // Rows from the lowest one upwards, `count` at most. Valid until something is printed.
  void rows_upwards(const ConsoleLog& log, std::size_t count, std::vector<std::string_view>& out_rows);

 private:
  struct Row {
    std::uint64_t line = 0;
    std::size_t row = 0;  // of the line
    auto operator<=>(const Row&) const = default;
  };
  int page_step() const;
  std::size_t rows_of(const ConsoleLog& log, std::uint64_t line) const;
  Row last(const ConsoleLog& log) const;
  // The row that is shown lowest, where it is now. The log is not empty.
  Row lowest(const ConsoleLog& log) const;
  Row moved_up(const ConsoleLog& log, Row from, std::size_t rows) const;
  Row moved_down(const ConsoleLog& log, Row from, std::size_t rows) const;
  void show(const ConsoleLog& log, const Row& wanted);

  int columns_ = 1, page_rows_ = 1;
  std::optional<Row> lowest_;  // none: the last that there is
  std::vector<std::string_view> line_rows_;
};

}  // namespace temblor::client
