// Numbers as text, in the format of the original's ftos() and vtos(), which game code may compare or cut
// apart.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "math/vec.h"

namespace temblor::builtins {

// "12", "-3", "  0.5": a whole number as it is; another one with one decimal, in at least five characters.
inline std::string number_text(float value) {
  const bool is_whole = std::fabs(value) < 2147483648.0f && value == std::trunc(value);
  return is_whole ? fmt::format("{}", static_cast<int>(value)) : fmt::format("{:>5.1f}", value);
}

// "'  1.0   2.5  -3.0'"
inline std::string vector_text(const math::Vec3& value) {
  return fmt::format("'{:>5.1f} {:>5.1f} {:>5.1f}'", value.x, value.y, value.z);
}

}  // namespace temblor::builtins
