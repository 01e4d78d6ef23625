// Levels with faces that other things are visible through.
#pragma once

#include <memory>

#include "support/levels/drawable_level.h"

namespace temblor::test {

// Returns a copy in which every other ordinary texture has holes: stripes of transparent texels, and single
// ones.
DrawableLevel with_fences(const DrawableLevel& drawable);

}  // namespace temblor::test
