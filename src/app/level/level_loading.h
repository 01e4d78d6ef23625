// Loads the level that --basedir, --game, and --map name, with its palette.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "assets/assets.h"
#include "assets/library.h"
#include "base/result.h"

namespace temblor::app {

struct LoadedMap {
  std::shared_ptr<const world::Level> level;
  assets::Look look;
  // The game data, in which the level is maps/NAME.bsp, even if its file is elsewhere. Null: there is none.
  std::shared_ptr<const assets::Library> library;
  // NAME of the level in `library`.
  std::string name;
  // Tolerated problems, one line each.
  std::vector<std::string> notes;
};

// `map` is a level's name ("start"), the path of a .bsp, or empty for the small built-in level. Only a name
// needs game data. The error for an unknown name lists similar names.
base::Result<LoadedMap> load_map(const GameFolders& folders, const std::string& map);

}  // namespace temblor::app
