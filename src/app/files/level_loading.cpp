#include "app/files/level_loading.h"

#include <fmt/format.h>

#include "app/files/game_files.h"
#include "artgen/small_level.h"
#include "base/text.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr std::string_view kMapFolder = "maps/";
constexpr std::string_view kMapSuffix = ".bsp";

// Returns the names of all levels that can be played. Boxes of ammunition and health (b_*.bsp) are levels,
// too, but only models of items.
std::vector<std::string> list_playable_levels(const vfs::FileSystem& files) {
  std::vector<std::string> names = list_stems(files, kMapFolder, kMapSuffix);
  std::erase_if(names, [](const std::string& name) { return name.starts_with("b_"); });
  return names;
}

base::Result<LoadedMap> load_small_level() {
  LoadedMap loaded;
  loaded.look = make_builtin_look();
  TRY(loaded.level, world::make_level(artgen::make_small_level({.colored_light = true}), "small level"));
  return loaded;
}

// A name with .bsp is a path on disk; any other name is searched in the game directories.
base::Result<assets::LoadedLevel> load_level(const GameFolders& folders, const std::string& map) {
  if (base::to_lower(map).ends_with(kMapSuffix)) return assets::load_level_file(map);
  TRY(const vfs::FileSystem files, open_files(folders));
  const std::string path = fmt::format("{}{}{}", kMapFolder, map, kMapSuffix);
  if (files.contains(path)) return assets::load_level(files, map);
  base::Error error =
      base::error(ErrorCode::kNotFound, "no such level in {}; {}",
                  files.folders().back().parent_path().string(), suggest(map, list_playable_levels(files)));
  error.file = path;
  return error;
}

}  // namespace

base::Result<LoadedMap> load_map(const GameFolders& folders, const std::string& map) {
  if (map.empty()) return load_small_level();
  LoadedMap loaded;
  TRY(loaded.look, find_look(folders));
  TRY(assets::LoadedLevel level, load_level(folders, map));
  loaded.level = std::move(level.level);
  loaded.notes = std::move(level.notes);
  return loaded;
}

}  // namespace temblor::app
