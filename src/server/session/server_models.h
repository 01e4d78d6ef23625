// Models as a server needs them: boxes, and which are parts of the level. What they look like is the clients'
// business.
#pragma once

#include <string_view>
#include <vector>

#include "assets/library.h"
#include "base/result.h"
#include "server/game_world.h"

namespace temblor::server {

// The level itself and its parts "*1", "*2", ..., numbered from 1; [0] is none.
std::vector<ServerModel> models_of_level(const world::Level& level, std::string_view path);

// Any other: a box of +-16 units for alias models (as in the original, whatever their size) and sprites, the
// level's bounds for a .bsp. Errors name the file.
base::Result<ServerModel> load_server_model(const assets::Library& library, std::string_view name);

}  // namespace temblor::server
