#include "app/level_loading.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <tuple>

#include "artgen/palette.h"
#include "artgen/small_level.h"
#include "base/text.h"

namespace temblor::app {
namespace {

using base::ErrorCode;

constexpr std::string_view kMapFolder = "maps/";
constexpr std::string_view kMapSuffix = ".bsp";
constexpr std::size_t kSuggestions = 8;

base::Result<vfs::FileSystem> open_files(const GameFolders& folders) {
  if (folders.base_folder.empty() && !std::filesystem::is_directory("id1"))
    return base::error(ErrorCode::kNotFound,
                       "no game data: the current folder holds no id1; name the folder that does with "
                       "--basedir DIR, or leave --map out to draw the level made in code");
  const std::filesystem::path base_folder = folders.base_folder.empty() ? "." : folders.base_folder;
  return vfs::FileSystem::open(base_folder, folders.games);
}

// Levenshtein: single characters inserted, removed or replaced to turn one into the other.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

// The names most like `map` of the levels that are there.
std::vector<std::string> similar_maps(const vfs::FileSystem& files, const std::string& map) {
  std::vector<std::string> names;
  for (const std::string& path : files.list(kMapFolder, kMapSuffix)) {
    const std::string name =
        path.substr(kMapFolder.size(), path.size() - kMapFolder.size() - kMapSuffix.size());
    if (!name.starts_with("b_")) names.push_back(name);  // boxes of ammunition and health, not places
  }
  const std::string wanted = base::to_lower(map);
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::tuple(edit_distance(wanted, a), a) < std::tuple(edit_distance(wanted, b), b);
  });
  names.resize(std::min(names.size(), kSuggestions));
  return names;
}

base::Result<LoadedMap> load_small_level() {
  LoadedMap loaded;
  loaded.look.palette = artgen::make_palette();
  loaded.look.colormap = formats::make_colormap(loaded.look.palette);
  TRY(loaded.level, world::make_level(artgen::make_small_level({.coloured_light = true}), "small level"));
  return loaded;
}

base::Result<assets::LoadedLevel> load_named_level(const vfs::FileSystem& files, const std::string& map) {
  const std::string path = fmt::format("{}{}{}", kMapFolder, map, kMapSuffix);
  if (files.contains(path)) return assets::load_level(files, map);
  const std::vector<std::string> names = similar_maps(files, map);
  base::Error error = base::error(
      ErrorCode::kNotFound, "no such level in {}; {}", files.folders().back().parent_path().string(),
      names.empty() ? "there are no levels at all"
                    : fmt::format("there are, for example, {}", fmt::join(names, ", ")));
  error.file = path;
  return error;
}

}  // namespace

base::Result<LoadedMap> load_map(const GameFolders& folders, const std::string& map) {
  if (map.empty()) return load_small_level();
  TRY(const vfs::FileSystem files, open_files(folders));
  LoadedMap loaded;
  TRY(loaded.look, assets::load_look(files));
  TRY(assets::LoadedLevel level, base::to_lower(map).ends_with(kMapSuffix) ? assets::load_level_file(map)
                                                                           : load_named_level(files, map));
  loaded.level = std::move(level.level);
  loaded.notes = std::move(level.notes);
  return loaded;
}

}  // namespace temblor::app
