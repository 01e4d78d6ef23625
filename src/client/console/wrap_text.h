// A line of the console's characters -> rows that are no wider than a number of columns.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace temblor::client {

// Takes the first row off: as much as fits, up to a space, which is left out (and is no row's first character
// but the line's); in the middle of a word where there is no space. `columns` > 0.
std::string_view take_row(std::string_view& io_line, int columns);

// All of its rows; an empty line has one.
void wrap_line(std::string_view line, int columns, std::vector<std::string_view>& out_rows);
std::size_t count_rows(std::string_view line, int columns);

}  // namespace temblor::client
