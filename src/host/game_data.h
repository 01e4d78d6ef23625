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
  bool operator==(const GameFolders&) const = default;
};

struct GameData {
  // Fails where the folders cannot be read or hold no palette.
  static base::Result<std::unique_ptr<GameData>> open(const GameFolders& folders);

  GameData(vfs::FileSystem files, assets::Look look);
  GameData(const GameData&) = delete;
  GameData& operator=(const GameData&) = delete;

  // Where what is written goes.
  const std::filesystem::path& write_folder() const { return library.files().folders().back(); }

  assets::Library library;
  assets::Look look;
  client::Presentation presentation;
  render::Renderer renderer;
};

}  // namespace temblor::host
