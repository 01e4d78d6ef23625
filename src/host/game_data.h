// Everything that comes out of the game folders, so that all of it is exchanged at once when they are.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "assets/library.h"
#include "client/presentation.h"
#include "render/renderer.h"

namespace temblor::host {

struct GameFolders {
  std::filesystem::path base_folder;
  std::vector<std::string> games;  // besides id1
  std::filesystem::path user_folder{};
  bool operator==(const GameFolders&) const = default;
};

struct GameData {
  // Fails where the folders cannot be read or hold no palette.
  static base::Result<std::unique_ptr<GameData>> open(const GameFolders& folders);

  GameData(vfs::FileSystem files, assets::Look look, std::vector<std::filesystem::path> write_folders);
  GameData(const GameData&) = delete;
  GameData& operator=(const GameData&) = delete;

  assets::Library library;
  // Where each of the game folders, in their order, has its settings and what else is written: the folder
  // itself, or where nobody may write there, one of its name in GameFolders::user_folder.
  std::vector<std::filesystem::path> write_folders;
  // The last of them: where settings, saved games, recordings and pictures go.
  std::filesystem::path write_folder;
  assets::Look look;
  client::Presentation presentation;
  render::Renderer renderer;
};

}  // namespace temblor::host
