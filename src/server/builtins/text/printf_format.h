// DP_QC_SPRINTF: text from a format and the machine's parameters behind it, as C's printf makes it.
#pragma once

#include <string>
#include <string_view>

#include "vm/machine.h"

namespace temblor::server {

// A directive is %[index$][flags][width][.precision][length]conversion; width and precision may be "*", read
// from the next value.
//   %d %c %x %X %o %u  a float, cut to a whole number     %f %F %e %E %g %G  a float
//   %s  a string       %v  a vector, each component as %g %%  a percent sign
//   %i  a word that is a whole number, as other machines have; one that can only be a float is taken as %d
// Lengths: "l" says that the word is a whole number, "h" that it is a float. `first` is the parameter of
// value 1; a value that was not passed is 0 or empty. A directive that makes no sense stands as it is. Widths
// and precisions are at most 512, and the text at most kMaxFormattedChars.
constexpr std::size_t kMaxFormattedChars = std::size_t{1} << 16;
std::string format_parameters(std::string_view format, vm::Machine& io_machine, int first);

}  // namespace temblor::server
