// The ArtMaker of `level NAME ...`: a level script becomes maps/NAME.map, which the level compiler turns into
// a BSP.
#pragma once

#include <vector>

#include "artgen/art.h"

namespace temblor::artgen {

// Fails for scripts that do not parse and for entities inside solids.
base::Result<std::vector<ArtPart>> make_level(const ScriptLine& level);

}  // namespace temblor::artgen
