#include "compiler/bsp/brushes/level_entities.h"

#include "base/check.h"
#include "compiler/bsp/brushes/brush_class.h"

namespace temblor::compiler {
bool is_editor_key(std::string_view key) {
  return key.starts_with("_tb_") || key == "mapversion";
}

// Keeps the order of the keys: a later run must get the same bytes from the same map.
formats::Entity make_level_fields(const formats::Entity& from, const BrushEntity& brushes) {
  formats::Entity fields;
  const auto is_replaced = [&](const std::string& key) {
    return (key == "model" && !brushes.model.empty()) || (key == "origin" && !brushes.origin.empty());
  };
  for (const auto& [key, value] : from.pairs)
    if (!is_editor_key(key) && !is_replaced(key)) fields.pairs.emplace_back(key, value);
  if (!brushes.origin.empty()) fields.pairs.emplace_back("origin", brushes.origin);
  if (!brushes.model.empty()) fields.pairs.emplace_back("model", brushes.model);
  return fields;
}

bool is_point_entity(const formats::MapEntity& entity) {
  return entity.brushes.empty() && !find_brush_class(entity.fields).is_world;
}

std::vector<formats::Entity> make_level_entities(const formats::Map& map,
                                                 std::span<const BrushEntity> brush_entities) {
  std::vector<formats::Entity> entities;
  std::size_t next = 0;
  for (const formats::MapEntity& entity : map.entities) {
    if (is_point_entity(entity)) {
      entities.push_back(make_level_fields(entity.fields, {}));
      continue;
    }
    CHECK(next < brush_entities.size(), "a map of {} brush entities", brush_entities.size());
    const BrushEntity& brushes = brush_entities[next++];
    if (brushes.is_in_level) entities.push_back(make_level_fields(entity.fields, brushes));
  }
  CHECK(next == brush_entities.size(), "{} of {} brush entities", next, brush_entities.size());
  return entities;
}

}  // namespace temblor::compiler
