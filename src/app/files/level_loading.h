// From the command line's --basedir, --game and --map to a level with its palette.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/commands/options.h"
#include "assets/assets.h"
#include "base/result.h"

namespace temblor::app {

struct LoadedMap {
  std::shared_ptr<const world::Level> level;
  assets::Look look;
  std::vector<std::string> notes;  // what was made do with, one line each
};

// `map`: a level's name ("start"), a path to a .bsp on disk, or empty for the small level that is made in
// code and needs no data. An unknown name gets an error that lists levels that are there.
base::Result<LoadedMap> load_map(const GameFolders& folders, const std::string& map);

}  // namespace temblor::app
