// Numbers in text, as the C library's atof reads them: blanks are passed over, and what follows the number
// too.
#pragma once

#include <string_view>

#include "math/vec.h"

namespace temblor::server {

// 0 where there is no number; the largest there is in place of one beyond it.
float number_from(std::string_view text);
// "'1 2 3'" or "1 2 3"; components that are not there are 0.
math::Vec3 vector_from(std::string_view text);

}  // namespace temblor::server
