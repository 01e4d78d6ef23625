// Finds mistakes in a map's entities: wrong order, missing class names, brushes, and lights, overlong values,
// and misspelled keys.
#pragma once

#include "base/result.h"
#include "compiler/report.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Fails if the first entity is not worldspawn; the error says which line has it.
base::Status check_worldspawn(const formats::Map& map);

// Warns, with entity and line, about
// - entities without a class name;
// - entities of Quake's brush classes that have neither brushes nor a model;
// - values of more than 4,096 characters, except those that do not go into the level;
// - keys with an underscore in front that no program reads (key_names.h);
// - names of lights (_surflight_targetname) that no light has.
void warn_about_entity_faults(const formats::Map& map, Warnings& io_warnings);

}  // namespace temblor::compiler
