// Opens the game folders that the command line names, and finds names like a mistyped one.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/options.h"
#include "assets/assets.h"
#include "base/result.h"
#include "vfs/file_system.h"

namespace temblor::app {

// The folder that --basedir names, or the current one where it holds id1, or the shipped game's, which lies
// beside the program or where it is installed; else fails, saying what to do.
base::Result<std::filesystem::path> find_base_folder(const GameFolders& folders);
// Whether it is that of the game that was installed with this program: not for writing to, even by those who
// may.
bool is_installed_game(const std::filesystem::path& base_folder);
base::Result<vfs::FileSystem> open_files(const GameFolders& folders);

// The palette that the level made in code is painted with, and what follows from it.
assets::Look own_look();

// The game's; Temblor's own, as the shipped game has it, where no --basedir is given and the current folder
// holds no id1.
base::Result<assets::Look> find_look(const GameFolders& folders);

// "there are, for example, a, b, c": of `names`, those most like `wanted`; "there are none at all" without
// any.
std::string suggest(std::string_view wanted, std::vector<std::string> names);

// The files FOLDER*SUFFIX without folder and suffix.
std::vector<std::string> stems(const vfs::FileSystem& files, std::string_view folder,
                               std::string_view suffix);

}  // namespace temblor::app
