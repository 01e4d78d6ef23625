// Reads a level script, checks it, and converts it to a map for the compiler. The pipeline is shown in
// level_script.h.
#pragma once

#include "artgen/level_script/level_script.h"
#include "base/result.h"
#include "formats/levels/map.h"

namespace temblor::artgen {

// Reads a `level` line with everything under it, which must outlive the result. Errors begin with the line's
// number.
base::Result<LevelScript> read_level_script(const ScriptLine& level);

// Makes the shell around the spaces, the rock, and the bands, and converts all solids to brushes.
formats::Map make_map(const LevelScript& script);

// Finds point entities that are in solid rock or inside a solid. The error lists up to eight of them with
// their lines.
base::Status check_level_script(const LevelScript& script);

}  // namespace temblor::artgen
