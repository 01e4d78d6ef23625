// Spawns a level's entities: stores their keys in fields, then calls the QuakeC function with the name of
// their class.
//    { "classname" "light"  "origin" "0 64 32" }  -->  fields classname, origin  -->  light()
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/function_ref.h"
#include "base/result.h"
#include "formats/levels/entities.h"
#include "server/game/game_world.h"
#include "vm/machine.h"
#include "world/spawn_rules.h"

namespace temblor::server {

struct SpawnReport {
  std::size_t spawned = 0;
  std::size_t filtered = 0;        // left out, because of this skill or kind of game
  std::vector<std::string> notes;  // keys that the program does not know, each once
  // Classes without a spawn function, each with its first entity. Entities are counted from 0, as in the
  // level's text.
  std::vector<std::string> unknown_classes;
};

// The first entity becomes the world, entity 0. Entities that their spawnflags exclude from this game, and
// those without a spawn function, are removed; but see half_life/brush_entities.h. `after_each` runs after
// each spawn function. Fails if QuakeC does, or if there are too many entities.
base::Result<SpawnReport> spawn_entities(GameWorld& io_world, vm::Machine& io_machine,
                                         std::span<const formats::Entity> entities,
                                         const world::SpawnRules& rules,
                                         base::FunctionRef<void()> after_each);

}  // namespace temblor::server
