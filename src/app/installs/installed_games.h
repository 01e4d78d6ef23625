// Finds Quake and its 2021 release where stores install them: Steam (also from Flatpak and Snap; Windows
// games of Proton are in the same place), GOG, Heroic, and Lutris. Looks only at the places that these
// programs use or name in their files, and never searches a disk. Reads nothing but those files and lists of
// folders.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace temblor::app {

// The user's folders, from the environment (HOME, XDG_CONFIG_HOME, XDG_DATA_HOME). Empty: unknown.
struct UserFolders {
  std::filesystem::path home, config, data;
};
UserFolders find_user_folders();

struct InstalledGame {
  std::string title;                  // "Quake (Steam)", "Quake, 2021 release (GOG)"
  std::filesystem::path base_folder;  // holds id1
};

// Returns each game once, the 2021 release of a place before the game of 1996, at most kMaxInstalledGames.
constexpr std::size_t kMaxInstalledGames = 16;
std::vector<InstalledGame> find_installed_games(const UserFolders& user);

}  // namespace temblor::app
