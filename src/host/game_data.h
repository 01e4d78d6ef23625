// Everything that comes out of the game folders, so that all of it is exchanged at once when they are.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assets/library.h"
#include "client/view/presentation.h"
#include "render/renderer.h"

namespace temblor::host {

struct GameFolders {
  std::filesystem::path base_folder;
  std::vector<std::string> games;       // besides id1
  std::filesystem::path user_folder{};  // of the player's own files; empty: there is none
  bool is_installed = false;  // the base folder belongs to an installation: nothing is written there
  bool operator==(const GameFolders&) const = default;
};

// The game folders as they are read, and for each of them, in their order, where its settings and what else
// is written go: the folder itself, or where nobody may write there, one of its name in
// GameFolders::user_folder, whose files are then read before the game's own.
struct MountedGames {
  vfs::FileSystem files;
  std::vector<std::filesystem::path> write_folders;
};
// Makes the last of write_folders. Fails where the folders cannot be read.
base::Result<MountedGames> mount_games(const GameFolders& folders);

struct GameData {
  // Fails where the folders cannot be read or hold no palette.
  static base::Result<std::unique_ptr<GameData>> open(const GameFolders& folders);

  GameData(MountedGames games, assets::Look look);
  GameData(const GameData&) = delete;
  GameData& operator=(const GameData&) = delete;

  assets::Library library;
  // As of MountedGames.
  std::vector<std::filesystem::path> write_folders;
  // The last of them: where settings, saved games, recordings and pictures go.
  std::filesystem::path write_folder;
  assets::Look look;
  client::Presentation presentation;
  render::Renderer renderer;
};

}  // namespace temblor::host
