// Finds entity keys whose values the compiler or the game would silently ignore because they are not the
// numbers that the key takes.
#pragma once

#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Warns about each, with its entity and line. Empty values are fine: editors leave them.
void warn_about_unreadable_values(const formats::Map& map, Warnings& io_warnings);

}  // namespace temblor::compiler
