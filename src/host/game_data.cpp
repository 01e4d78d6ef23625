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
  if (folders.user_folder.empty() || (!folders.is_installed && can_write_to(game))) return game;
  return folders.user_folder / game.filename();
}

}  // namespace

base::Result<MountedGames> mount_games(const GameFolders& folders) {
  TRY(vfs::FileSystem files, vfs::FileSystem::open(folders.base_folder, folders.games));
  std::vector<std::filesystem::path> write_folders;
  std::error_code ignored;
  for (const std::filesystem::path& game : files.folders()) {
    // Nothing is written to those below the last one: they are asked only where it matters.
    const bool is_last = game == files.folders().back();
    const bool has_other = std::filesystem::exists(folders.user_folder / game.filename(), ignored);
    write_folders.push_back(is_last || has_other ? folder_to_write(folders, game) : game);
  }
  for (std::size_t game = 0; game < write_folders.size(); ++game)
    if (write_folders[game] != files.folders()[game]) TRY_STATUS(files.mount_over(game, write_folders[game]));
  std::filesystem::create_directories(write_folders.back(), ignored);
  return MountedGames{std::move(files), std::move(write_folders)};
}

GameData::GameData(MountedGames games, assets::Look own_look)
    : library(std::move(games.files)),
      write_folders(std::move(games.write_folders)),
      write_folder(write_folders.back()),
      look(own_look),
      presentation(library),
      renderer(look.palette, look.colormap) {}

base::Result<std::unique_ptr<GameData>> GameData::open(const GameFolders& folders) {
  TRY(MountedGames games, mount_games(folders));
  TRY(const assets::Look look, assets::load_look(games.files));
  return std::make_unique<GameData>(std::move(games), look);
}

}  // namespace temblor::host
