#include "client/console/wrap_text.h"

namespace temblor::client {

namespace {

bool is_space(char c) {
  constexpr int kShape = 0x7f;  // spaces are bronze too
  return (c & kShape) == ' ';
}

}  // namespace

std::string_view take_row(std::string_view& io_line, int columns) {
  const auto most = static_cast<std::size_t>(columns);
  std::size_t end = io_line.size(), next = end;
  if (end > most) {
    end = next = most;
    for (std::size_t space = most; space > 0; --space) {
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
  do out_rows.push_back(take_row(line, columns));
  while (!line.empty());
}

std::size_t count_rows(std::string_view line, int columns) {
  std::size_t rows = 0;
  do {
    take_row(line, columns);
    ++rows;
  } while (!line.empty());
  return rows;
}

}  // namespace temblor::client
