// Keys of worldspawn that the command line sets for light. The level must not keep them: it would be lit in
// the same way by the next run without them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.h"
#include "formats/levels/bsp.h"
#include "formats/levels/entities.h"

namespace temblor::compiler {

// Names without the underscore, and values.
using WorldKeys = std::vector<std::pair<std::string, std::string>>;

// Replaces keys of an entity, with and without an underscore in front, by ones with it.
void set_keys(const WorldKeys& keys, formats::Entity& io_entity);

// Replaces keys of the level's worldspawn, and returns the worldspawn that it had. Fails if the entity text
// does not parse or is empty.
base::Result<formats::Entity> override_world_keys(const WorldKeys& keys, formats::Bsp& io_bsp);
// Puts the worldspawn back; the other entities stay as they are.
base::Status restore_worldspawn(formats::Entity worldspawn, formats::Bsp& io_bsp);

}  // namespace temblor::compiler
