#include "client/console/wrap_text.h"

namespace temblor::client {

namespace {

bool is_space(char c) {
  constexpr int kShape = 0x7f;  // spaces are bronze too
  return (c & kShape) == ' ';
}

}  // namespace

std::string_view split_first_row(std::string_view& io_line, int columns) {
  const auto max_chars = static_cast<std::size_t>(columns);
  // Looks backward from one character past the row for a space; a space exactly there lets the row be full.
  std::size_t end = io_line.size(), next = end;
  if (end > max_chars) {
    end = next = max_chars;
    for (std::size_t space = max_chars; space > 0; --space) {
      if (!is_space(io_line[space])) continue;
      end = space;
      next = space + 1;
      break;
    }
  }
  const std::string_view row = io_line.substr(0, end);
  io_line.remove_prefix(next);
  return row;
}

void wrap_line(std::string_view line, int columns, std::vector<std::string_view>& out_rows) {
  out_rows.clear();
  do out_rows.push_back(split_first_row(line, columns));
  while (!line.empty());
}

std::size_t count_rows(std::string_view line, int columns) {
  std::size_t rows = 0;
  do {
    split_first_row(line, columns);
    ++rows;
  } while (!line.empty());
  return rows;
}

}  // namespace temblor::client
