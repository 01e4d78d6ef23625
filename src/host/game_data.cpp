#include "host/game_data.h"

#include <fstream>

namespace temblor::host {

namespace {

// Asks by doing: rights alone do not tell of a disk that is mounted to be read.
bool can_write_to(const std::filesystem::path& folder) {
  const std::filesystem::path probe = folder / ".temblor-may-write";
  const bool written = std::ofstream(probe).good();
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
  return written;
}

std::filesystem::path folder_to_write(const GameFolders& folders, const std::filesystem::path& game) {
  if (folders.user_folder.empty() || can_write_to(game)) return game;
  const std::filesystem::path own = folders.user_folder / game.filename();
  std::error_code ignored;
  std::filesystem::create_directories(own, ignored);
  return own;
}

}  // namespace

GameData::GameData(vfs::FileSystem files, assets::Look own_look, std::filesystem::path folder)
    : library(std::move(files)),
      write_folder(std::move(folder)),
      look(own_look),
      presentation(library),
      renderer(look.palette, look.colormap) {}

base::Result<std::unique_ptr<GameData>> GameData::open(const GameFolders& folders) {
  TRY(vfs::FileSystem files, vfs::FileSystem::open(folders.base_folder, folders.games));
  TRY(const assets::Look look, assets::load_look(files));
  std::filesystem::path write_folder = folder_to_write(folders, files.folders().back());
  return std::make_unique<GameData>(std::move(files), look, std::move(write_folder));
}

}  // namespace temblor::host
