#include "app/level/level_loading.h"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "app/files/game_files.h"
#include "app/level/builtin_palette.h"
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

void attach_level(assets::LoadedLevel level, LoadedMap& io_loaded) {
  io_loaded.level = std::move(level.level);
  std::move(level.notes.begin(), level.notes.end(), std::back_inserter(io_loaded.notes));
}

// Loads a level of the game directories.
base::Result<LoadedMap> load_named_level(const GameFolders& folders, const std::string& name) {
  LoadedMap loaded;
  loaded.name = name;
  TRY(loaded.look, find_look(folders));
  TRY(vfs::FileSystem files, open_files(folders));
  const std::string path = fmt::format("{}{}{}", kMapFolder, name, kMapSuffix);
  if (!files.contains(path)) {
    base::Error error = base::error(ErrorCode::kNotFound, "no such level in {}; {}",
                                    files.folders().back().parent_path().string(),
                                    suggest(name, list_playable_levels(files)));
    error.file = path;
    return error;
  }
  TRY(assets::LoadedLevel level, assets::load_level(files, name, {.external_textures = true}));
  attach_level(std::move(level), loaded);
  loaded.library = std::make_shared<const assets::Library>(std::move(files));
  return loaded;
}

// Opens the game data for a level that may do without. Null if none was named and there is none.
base::Result<std::optional<vfs::FileSystem>> open_optional_files(const GameFolders& folders) {
  base::Result<std::filesystem::path> base_folder = find_base_folder(folders);
  if (!base_folder.ok()) return std::optional<vfs::FileSystem>();
  TRY(vfs::FileSystem files, vfs::FileSystem::open(*base_folder, folders.games));
  return std::optional(std::move(files));
}

// A palette of one's own is no reason not to draw a level.
base::Result<assets::Look> find_optional_look(const GameFolders& folders,
                                              std::vector<std::string>& io_notes) {
  base::Result<assets::Look> look = find_look(folders);
  if (look.ok() || look.error().code != ErrorCode::kNotFound) return look;
  io_notes.push_back(fmt::format("{}; the built-in palette is used", look.error().message()));
  return make_builtin_look();
}

// Without game data, a level is drawn with the built-in palette.
base::Status check_palette(const GameFolders& folders, LoadedMap& io_loaded) {
  TRY(const bool fits, fits_builtin_palette(*io_loaded.level, folders));
  if (!fits)
    io_loaded.notes.push_back(fmt::format(
        "{}: drawn with Temblor's palette; if the level is of another game, its colors are wrong: "
        "name that game with --basedir DIR",
        io_loaded.name));
  return base::Ok{};
}

// Puts the level and its .lit in the place of those that a game directory may have under the same name.
void mount_level(const std::filesystem::path& file, const std::string& name, vfs::FileSystem& io_files) {
  const std::string stem = fmt::format("{}{}", kMapFolder, name);
  std::filesystem::path lit = file;
  lit.replace_extension(".lit");
  io_files.mount_file(stem + std::string(kMapSuffix), file);
  io_files.hide_file(stem + ".lit");
  if (std::error_code ignored; std::filesystem::exists(lit, ignored)) io_files.mount_file(stem + ".lit", lit);
}

// Loads a level from disk.
base::Result<LoadedMap> load_level_on_disk(const GameFolders& folders, const std::filesystem::path& file) {
  LoadedMap loaded;
  loaded.name = file.stem().string();
  TRY(std::optional<vfs::FileSystem> files, open_optional_files(folders));
  TRY(loaded.look, find_optional_look(folders, loaded.notes));
  TRY(assets::LoadedLevel level, assets::load_level_file(file, loaded.look.palette));
  attach_level(std::move(level), loaded);
  if (has_no_game_data(folders)) TRY_STATUS(check_palette(folders, loaded));
  if (!files) return loaded;
  mount_level(file, loaded.name, *files);
  loaded.library = std::make_shared<const assets::Library>(*std::move(files));
  return loaded;
}

}  // namespace

base::Result<LoadedMap> load_map(const GameFolders& folders, const std::string& map) {
  if (map.empty()) return load_small_level();
  if (base::to_lower(map).ends_with(kMapSuffix)) return load_level_on_disk(folders, map);
  return load_named_level(folders, map);
}

}  // namespace temblor::app
