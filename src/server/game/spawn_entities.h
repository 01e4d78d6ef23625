// A level's entities, brought to life: keys into fields, then the function named like the class.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/function_ref.h"
#include "base/result.h"
#include "formats/levels/entities.h"
#include "server/game_world.h"
#include "vm/machine.h"

namespace temblor::server {

struct SpawnRules {
  int skill = 1;  // 0 to 3
  bool deathmatch = false;
};

struct SpawnReport {
  std::size_t spawned = 0;
  std::size_t filtered = 0;        // not for this skill or kind of game
  std::vector<std::string> notes;  // keys that the program does not know, each once
  // Classes that it does not know, each with its first entity, as the level's text counts them, from 0.
  std::vector<std::string> unknown_classes;
};

// The first entity becomes the world, entity 0; those whose spawnflags leave them out are passed over, and
// those without a spawn function are left out with a note. `after_each` is called when a spawn function has
// returned. Fails where QuakeC does, or where there is no room for all of them.
base::Result<SpawnReport> spawn_entities(GameWorld& io_world, vm::Machine& io_machine,
                                         std::span<const formats::Entity> entities, const SpawnRules& rules,
                                         base::FunctionRef<void()> after_each);

}  // namespace temblor::server
