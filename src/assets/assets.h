// Names to loaded things: levels, and what every picture needs (palette and colormap).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/images/palette.h"
#include "vfs/file_system.h"
#include "world/level.h"

namespace temblor::assets {

struct LoadedLevel {
  std::shared_ptr<const world::Level> level;
  // What was made do with, one line each for a person: a texture that is missing, a .lit that does not fit.
  std::vector<std::string> notes;
};

// maps/NAME.bsp with its maps/NAME.lit, if that is there, comes from the same game folder or a later one, and
// fits (else it is left out, with a note). `map_name` is "start", not "maps/start.bsp". Errors name the file.
base::Result<LoadedLevel> load_level(const vfs::FileSystem& files, std::string_view map_name);

// The same for a .bsp anywhere on disk, with the .lit beside it.
base::Result<LoadedLevel> load_level_file(const std::filesystem::path& path);

struct Look {
  formats::Palette palette;
  formats::Colormap colormap;
};

// gfx/palette.lmp and gfx/colormap.lmp; a colormap that is missing is made from the palette.
base::Result<Look> load_look(const vfs::FileSystem& files);

}  // namespace temblor::assets
