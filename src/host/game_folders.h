// The folders that a game is read from, and those that its settings and saved games are written to.
//
// Each game folder ("id1", "mymod") has a write folder: the game folder itself if it is writable, otherwise a
// folder of the same name in the player's own data (GameFolders::user_folder). The files in the write folder
// are then found before those of the game:
//
//   base_folder/id1     user_folder/id1       <- written, and searched first
//   base_folder/mymod   user_folder/mymod
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "vfs/file_system.h"

namespace temblor::host {

struct GameFolders {
  std::filesystem::path base_folder;  // holds id1
  // Folder names of mods, in addition to id1. Files of later ones replace those of earlier ones.
  std::vector<std::string> games;
  // Root of the player's own files. Empty: there is none, and everything is written to the game folders.
  std::filesystem::path user_folder{};
  // base_folder belongs to a system package: nothing is written below it, even if it is writable.
  bool is_installed = false;
  bool operator==(const GameFolders&) const = default;
};

struct MountedGames {
  vfs::FileSystem files;
  // For each game folder, in the order of `files`, the folder that is written to. Never empty: id1 is always
  // mounted. New files go to the last one.
  std::vector<std::filesystem::path> write_folders;
};

// Mounts the game folders and creates the last of write_folders. Fails if a folder cannot be read.
base::Result<MountedGames> mount_games(const GameFolders& folders);

}  // namespace temblor::host
