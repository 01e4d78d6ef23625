// The entities of a level: those of the map, less what only compilers and editors read, each with brushes
// naming its model.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/build/draft.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Whether an entity has no brushes, nor is of a kind that lives by them alone (func_group ...).
bool is_point_entity(const formats::MapEntity& entity);

// An entity's keys in the level. `brushes`: what became of its own, if it has any.
formats::Entity level_fields(const formats::Entity& from, const BrushEntity& brushes);

// All of them, but for a map of which only a region is compiled. `brush_entities` in the order of those
// entities of the map that are no points, one for each (CHECKed).
std::vector<formats::Entity> level_entities(const formats::Map& map,
                                            std::span<const BrushEntity> brush_entities);

}  // namespace temblor::compiler
