// Reads numbers from text like the C library's atof: skips blanks before the number, and ignores what follows
// it. Unlike atof, it does not depend on the locale.
#pragma once

#include <string_view>

#include "math/vec.h"

namespace temblor::builtins {

// 0 if there is no number. Numbers beyond the range of float become its largest.
float number_from(std::string_view text);
// Reads "'1 2 3'" or "1 2 3". Missing components are 0.
math::Vec3 vector_from(std::string_view text);

}  // namespace temblor::builtins
