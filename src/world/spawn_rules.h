// Which entities of a level take part in a game: their spawnflags exclude them from skills or from
// deathmatch.
#pragma once

#include "formats/levels/entities.h"

namespace temblor::world {

struct SpawnRules {
  int skill = 1;  // 0 to 3
  bool deathmatch = false;
};

// Whether an entity with these spawnflags is left out. In deathmatch, the skill does not matter.
bool is_excluded(int spawn_flags, const SpawnRules& rules);
// The value of an entity's key "spawnflags". 0 without it, and for a value that is no number.
int spawn_flags(const formats::Entity& entity);
// The same for the spawnflags of an entity.
bool is_excluded(const formats::Entity& entity, const SpawnRules& rules);

}  // namespace temblor::world
