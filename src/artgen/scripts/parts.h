// Parts: lines that several things share. "part NAME" makes nothing by itself; a line "use NAME" in a thing,
// or below one of its lines, stands for what is under the part, wherever among the scripts that is.
#pragma once

#include <map>
#include <string>

#include "artgen/scripts/script.h"
#include "base/result.h"

namespace temblor::artgen {

using Parts = std::map<std::string, const ScriptLine*>;

// Adds a part; two of one name are an error.
base::Status add_part(const ScriptLine& part, Parts& io_parts);

// The thing with every "use" replaced. Errors: no such part, one that uses itself.
base::Result<ScriptLine> with_parts(const ScriptLine& thing, const Parts& parts);

}  // namespace temblor::artgen
