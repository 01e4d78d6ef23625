// Loads levels with their colored light, and the palette and colormap that every frame needs. This layer
// joins the parts below: vfs finds the bytes, formats parses them, world makes a level of them.
//
//   maps/NAME.bsp -> formats::read_bsp() --+
//                                          +--> world::make_level() --> LoadedLevel (level, notes)
//   .ent, .vis, .lit (level/additions.h) --+
//   textures/ (level/external_textures.h) -+
//   WADs (level/wad_textures.h) -----------+
//
// A problem that leaves the level playable becomes a note instead of an error, because many released levels
// have one.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "formats/images/palette.h"
#include "vfs/file_system.h"
#include "world/level.h"

namespace temblor::assets {

// A level that is ready to play, shared and immutable.
struct LoadedLevel {
  std::shared_ptr<const world::Level> level;
  // Problems that did not prevent loading, one line each, with the file: missing textures, a .lit file that
  // does not match. For the console.
  std::vector<std::string> notes;
  std::string entities_file;  // the level, or the .ent file that replaces its entities
};

struct LevelOptions {
  // Replaces textures by the pictures in textures/. Servers need none.
  bool external_textures = false;
};

// Loads maps/NAME.bsp with the files next to it that replace parts of it, if they are in the same or a higher
// game folder. `map_name`: "start", not "maps/start.bsp". Returns kNotFound if there is no
// such level, and the reader's error if it is damaged; errors name the file. Thread-safe.
base::Result<LoadedLevel> load_level(const vfs::FileSystem& files, std::string_view map_name,
                                     const LevelOptions& options = {});

// Loads a .bsp from any path on disk, with the files next to it. For tools. Without the game's palette,
// textures that have one of their own keep its indices.
base::Result<LoadedLevel> load_level_file(const std::filesystem::path& path,
                                          const std::optional<formats::Palette>& palette = std::nullopt);

// The colors of the game: the palette translates indices to RGB, the colormap shades indices by light level.
struct Look {
  formats::Palette palette;
  formats::Colormap colormap;
};

// Loads gfx/palette.lmp and gfx/colormap.lmp; computes a missing colormap from the palette. A missing palette
// or a file of the wrong size is an error.
base::Result<Look> load_look(const vfs::FileSystem& files);

}  // namespace temblor::assets
