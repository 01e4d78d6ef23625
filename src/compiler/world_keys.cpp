#include "compiler/world_keys.h"

#include <string_view>

namespace temblor::compiler {

void set_keys(const WorldKeys& keys, formats::Entity& io_entity) {
  for (const auto& [name, value] : keys) {
    std::erase_if(io_entity.pairs, [&](const auto& pair) {
      return pair.first == name ||
             (pair.first.starts_with('_') && std::string_view(pair.first).substr(1) == name);
    });
    io_entity.pairs.emplace_back("_" + name, value);
  }
}

base::Result<formats::Entity> override_world_keys(const WorldKeys& keys, formats::Bsp& io_bsp) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(io_bsp.entities));
  if (entities.empty()) return base::malformed("the level has no worldspawn");
  formats::Entity worldspawn = entities.front();
  set_keys(keys, entities.front());
  io_bsp.entities = formats::write_entities(entities);
  return worldspawn;
}

base::Status restore_worldspawn(formats::Entity worldspawn, formats::Bsp& io_bsp) {
  TRY(std::vector<formats::Entity> entities, formats::read_entities(io_bsp.entities));
  if (entities.empty()) return base::malformed("the level has no worldspawn");
  entities.front() = std::move(worldspawn);
  io_bsp.entities = formats::write_entities(entities);
  return base::Ok{};
}

}  // namespace temblor::compiler
