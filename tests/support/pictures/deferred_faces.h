// Levels in which something shows through faces.
#pragma once

#include <memory>

#include "support/levels/drawable_level.h"

namespace temblor::test {

// A copy whose ordinary textures have holes, every other one of them: stripes of clear texels, and single
// ones.
DrawableLevel with_fences(const DrawableLevel& drawable);

}  // namespace temblor::test
