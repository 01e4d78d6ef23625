#include "host/game_data.h"

namespace temblor::host {

GameData::GameData(vfs::FileSystem files, assets::Look own_look)
    : library(std::move(files)),
      look(own_look),
      presentation(library),
      renderer(look.palette, look.colormap) {}

base::Result<std::unique_ptr<GameData>> GameData::open(const GameFolders& folders) {
  TRY(vfs::FileSystem files, vfs::FileSystem::open(folders.base_folder, folders.games));
  TRY(const assets::Look look, assets::load_look(files));
  return std::make_unique<GameData>(std::move(files), look);
}

}  // namespace temblor::host
