#include "host/game_folders.h"

#include <fstream>

namespace temblor::host {
namespace {

// Tries to create a file, because permissions alone do not reveal a disk that is mounted read-only.
bool can_write_to(const std::filesystem::path& folder) {
  const std::filesystem::path probe = folder / ".temblor-may-write";
  const bool written = std::ofstream(probe).good();
  std::error_code ignored;
  std::filesystem::remove(probe, ignored);
  return written;
}

// Prefers the game folder, so that a portable copy of the game keeps its saves and settings.
std::filesystem::path choose_write_folder(const GameFolders& folders, const std::filesystem::path& game) {
  if (folders.user_folder.empty() || (!folders.is_installed && can_write_to(game))) return game;
  return folders.user_folder / game.filename();
}

}  // namespace

base::Result<MountedGames> mount_games(const GameFolders& folders) {
  TRY(vfs::FileSystem files, vfs::FileSystem::open(folders.base_folder, folders.games));
  std::vector<std::filesystem::path> write_folders;
  std::error_code ignored;
  for (const std::filesystem::path& game : files.folders()) {
    // Only the last folder is written to. The earlier ones need a write folder only if the player already has
    // files there, for example the settings of id1; probing the others would touch the disk for nothing.
    const bool is_last = game == files.folders().back();
    const bool has_other = std::filesystem::exists(folders.user_folder / game.filename(), ignored);
    write_folders.push_back(is_last || has_other ? choose_write_folder(folders, game) : game);
  }
  // A separate write folder is searched before its game folder, so that the player's files win.
  for (std::size_t game = 0; game < write_folders.size(); ++game)
    if (write_folders[game] != files.folders()[game]) TRY_STATUS(files.mount_over(game, write_folders[game]));
  std::filesystem::create_directories(write_folders.back(), ignored);
  return MountedGames{std::move(files), std::move(write_folders)};
}

}  // namespace temblor::host
