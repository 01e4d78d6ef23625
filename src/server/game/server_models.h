// Models as a server needs them: their boxes, and which of them are parts of the level. Only clients draw
// them.
#pragma once

#include <string_view>
#include <vector>

#include "assets/library.h"
#include "base/result.h"
#include "server/game/game_world.h"

namespace temblor::server {

// The level itself as [1], then its parts "*1", "*2" and so on. [0] stands for no model.
std::vector<ServerModel> make_level_models(const world::Level& level, std::string_view path);

// Any other model. A .bsp has the box of its bounds, and an .md3 or .md5mesh that of all of its frames; .mdl
// files and sprites have one of +-16 units, whatever their size, as in the original. kNotFound or a format's
// error if it cannot be used; errors name the file.
base::Result<ServerModel> load_server_model(const assets::Library& library, std::string_view name);

}  // namespace temblor::server
