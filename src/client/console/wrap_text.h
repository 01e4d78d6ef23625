// Wraps a line of console characters to a number of columns. Rows are views into the line: nothing is copied.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace temblor::client {

// Removes the first row from the line and returns it: as much as fits, up to the last space that allows it,
// which is dropped. A word that is longer than a row is split. `columns` must be positive.
std::string_view split_first_row(std::string_view& io_line, int columns);

// All rows of a line, or their number; an empty line has one empty row.
void wrap_line(std::string_view line, int columns, std::vector<std::string_view>& out_rows);
std::size_t count_rows(std::string_view line, int columns);

}  // namespace temblor::client
