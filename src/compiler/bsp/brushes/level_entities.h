// The entities of a level: those of the map without the keys that only editors read. An entity with brushes
// names its model.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/bsp/draft.h"
#include "formats/levels/map.h"

namespace temblor::compiler {

// Whether an entity has no brushes and is not of a class that is made of brushes alone (func_group, ...).
bool is_point_entity(const formats::MapEntity& entity);

// Whether only editors read a key, so that levels do not have it: TrenchBroom's layers, the map format's
// version. The list of WADs stays in the level, since Half-Life finds textures by it.
bool is_editor_key(std::string_view key);

// Returns an entity's keys as the level has them. `brushes`: what became of its brushes, if it has any.
formats::Entity make_level_fields(const formats::Entity& from, const BrushEntity& brushes);

// Returns all entities of a map that is compiled as a whole. `brush_entities` has one entry for each entity
// that is not a point entity, in the order of the map (CHECKed).
std::vector<formats::Entity> make_level_entities(const formats::Map& map,
                                                 std::span<const BrushEntity> brush_entities);

}  // namespace temblor::compiler
