// The path of a leak (.pts), which map compilers write beside a level that leaks: one point a line, "X Y Z"
// in world units, from an entity to the void.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "math/vec.h"

namespace temblor::formats {

// Reads the points; the list may be empty. Empty lines are skipped, and further words on a line are ignored.
// The error of a line that does not begin with three finite numbers names its number.
base::Result<std::vector<math::Vec3>> read_pts(std::string_view text);

}  // namespace temblor::formats
