// The choice of the game data for `temblor play`:
//
//   --basedir        TEMBLOR_DATA        id1 in the        `basedir` in the        the shipped game, or the
//                                        current folder    user's settings         games that stores
//                                        installed
//   <- precedence                                                                  (the player is asked)
//
// The user's settings are the file temblor/temblor.cfg in XDG_CONFIG_HOME (~/.config), with one line for
// this:
//
//   basedir "/home/me/GOG Games/Quake"         basedir temblor: the shipped game
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/commands/options.h"
#include "app/installs/installed_games.h"
#include "base/result.h"
#include "host/host.h"

namespace temblor::app {

// The value of `basedir` that stands for the shipped game.
constexpr std::string_view kShippedGameName = "temblor";

// The file for the user's choice; empty if the user has no home.
std::filesystem::path find_choice_file(const UserFolders& user);
// Returns the value of `basedir`, with ~ replaced; nullopt if the file or the line is missing. Errors name
// the file and the line.
base::Result<std::optional<std::string>> read_choice(const std::filesystem::path& file,
                                                     const std::filesystem::path& home);
// Replaces the line, and keeps all others.
base::Status write_choice(const std::filesystem::path& file, std::string_view value);

struct GameChoice {
  std::filesystem::path base_folder;
  // For the menu: the shipped game and all others that were found. Empty if there is nothing to choose from.
  std::vector<host::GameSource> sources{};
  bool asks = false;      // the player has not chosen yet
  std::string warning{};  // the user's settings could not be used; empty: they could
};

// Returns kNotFound with advice if there is no game.
base::Result<GameChoice> choose_game(const GameFolders& folders, const UserFolders& user);

}  // namespace temblor::app
