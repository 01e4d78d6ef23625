// Reads where stores have installed games, from the files of their programs. The files belong to others and
// may be damaged, so the readers only collect paths: they skip everything that they do not know, never fail,
// and need time and memory in proportion to the text.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace temblor::app {

// Limit for the paths of one file; a player has a few.
constexpr std::size_t kMaxStorePaths = 256;

// Steam's libraryfolders.vdf: the folders that hold "steamapps". Both forms of the file:
//
//   "0" { "path" "/home/me/.steam" ... }       "1" "/mnt/games"
std::vector<std::filesystem::path> read_steam_libraries(std::string_view vdf);

// Heroic's installed.json, of GOG and Epic games: the value of each "install_path".
std::vector<std::filesystem::path> read_heroic_folders(std::string_view json);

// A game of Lutris, NAME.yml: the values of the lines "exe:", "main_file:", "working_dir:", and "prefix:"
// that are absolute paths.
std::vector<std::filesystem::path> read_lutris_paths(std::string_view yml);

}  // namespace temblor::app
