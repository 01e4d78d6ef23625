// Finds and opens the game data, and suggests names similar to a mistyped one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/options.h"
#include "assets/assets.h"
#include "base/result.h"
#include "formats/images/palette.h"
#include "vfs/file_system.h"

namespace temblor::app {

// Returns whether neither --basedir nor the current directory names game data.
bool has_no_game_data(const GameFolders& folders);
// Returns the directory that contains id1: --basedir, or the current directory if it contains id1, or that of
// the shipped game, beside the program or where it is installed. Otherwise kNotFound with advice.
base::Result<std::filesystem::path> find_base_folder(const GameFolders& folders);
// Returns whether that is the installed game. Nothing is written there, even with permission.
bool is_installed_game(const std::filesystem::path& base_folder);
// Opens id1 and the game directories that --game names.
base::Result<vfs::FileSystem> open_files(const GameFolders& folders);

// Returns Temblor's own palette and colormap, which the small built-in level uses.
assets::Look make_builtin_look();

// Returns the palette and colormap of the game data; Temblor's own if --basedir is not given and the current
// directory does not contain id1.
base::Result<assets::Look> find_look(const GameFolders& folders);
// Returns the palette only, without making a colormap for Temblor's own.
base::Result<formats::Palette> find_palette(const GameFolders& folders);

// Returns "similar names: a, b, c" with the names closest to `wanted` by edit distance, or "there are none".
std::string suggest(std::string_view wanted, std::vector<std::string> names);

// Lists the files FOLDER*SUFFIX without folder and suffix.
std::vector<std::string> list_stems(const vfs::FileSystem& files, std::string_view folder,
                                    std::string_view suffix);

}  // namespace temblor::app
