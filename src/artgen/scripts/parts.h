// Parts: lines that several assets share. A line "part NAME" at the left edge makes nothing itself. A line
// "use NAME", anywhere in an asset of any script, is replaced by the lines under that part.
#pragma once

#include <map>
#include <string>

#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen {

// Parts by name. The lines are owned by the scripts.
using Parts = std::map<std::string, const ScriptLine*>;

// Adds a part. Fails if its name is taken.
base::Status add_part(const ScriptLine& part, Parts& io_parts);

// Returns a copy of the asset in which every "use" line is replaced. Inserted lines remember their part for
// error messages. Fails for an unknown part and for parts that use each other in a circle.
base::Result<ScriptLine> expand_parts(const ScriptLine& asset, const Parts& parts);

}  // namespace temblor::artgen
