// Changes that the command line makes to a map before it is compiled: keys of worldspawn, and what becomes of
// detail brushes.
#pragma once

#include "app/compile/compile_options.h"
#include "formats/levels/map.h"

namespace temblor::app {

// Applies world_keys, omitted_detail, and no_detail. Entities and brushes keep their numbers, so that
// messages name them as editors do; an entity that is left out stays as an empty func_group.
void change_map(const CompileCommandOptions& options, formats::Map& io_map);

}  // namespace temblor::app
