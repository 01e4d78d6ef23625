#include "host/session/game_data.h"

namespace temblor::host {

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

std::string GameData::shorten_path(const std::filesystem::path& path) const {
  const std::filesystem::path game = library.files().folders().back();
  const std::filesystem::path below = path.lexically_relative(game);
  const bool is_inside = !below.empty() && *below.begin() != "..";
  return (is_inside ? game.filename() / below : path).string();
}

}  // namespace temblor::host
