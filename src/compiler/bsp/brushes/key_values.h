// Values that the compiler or the game would pass over because they are no such numbers as their key takes.
#pragma once

#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// A warning for each, with its entity and line: it counts as not given. Empty values say nothing, as editors
// leave them.
void warn_of_unreadable_values(const formats::Map& map, Warnings& io_warnings);

}  // namespace temblor::compiler
