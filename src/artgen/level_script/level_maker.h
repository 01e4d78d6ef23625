// `level NAME ...`: a plan becomes maps/NAME.map.
#pragma once

#include <vector>

#include "artgen/art.h"

namespace temblor::artgen {

base::Result<std::vector<ArtPart>> make_level(const ScriptLine& level);

}  // namespace temblor::artgen
