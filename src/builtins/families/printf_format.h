// DP_QC_SPRINTF: formats text like C's printf, from the machine's parameters. Formats come from game code, so
// any text is valid input.
#pragma once

#include <string>
#include <string_view>

#include "vm/machine.h"

namespace temblor::builtins {

// A directive is %[index$][flags][width][.precision][length]conversion; width and precision may be "*", which
// reads them from the next value.
//    %d %c %x %X %o %u  a float, truncated to a whole number     %f %F %e %E %g %G  a float
//    %s  a string       %v  a vector, each component as %g       %%  a percent sign
//    %i  a word that other engines' machines store as an integer; one that can only be a float is printed as
//    %d
// Length "l" says that the word is an integer, "h" that it is a float. `first` is the parameter of value 1; a
// value that was not passed is 0 or empty. A directive that makes no sense is copied as it is. Widths and
// precisions are at most 512, and the text at most kMaxFormattedChars.
constexpr std::size_t kMaxFormattedChars = std::size_t{1} << 16;
std::string format_parameters(std::string_view format, vm::Machine& io_machine, int first);

}  // namespace temblor::builtins
