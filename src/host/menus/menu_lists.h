// Supplies the menus with the host's lists: levels, saved games, demos, mods, servers.
//
// client::Menu knows neither files nor the host. It calls the functions of a MenuContent when a page needs
// their lists. Levels and their titles are cached for as long as the game folders stay the same, because
// their files do not change; saved games and demos are listed again each time.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "client/menu/menu_content.h"
#include "host/menus/thumbnails.h"

namespace temblor::host {

struct Host;

class MenuLists {
 public:
  // Both must outlive this object.
  MenuLists(Host& host, const GameData& data);
  // The functions in the result refer to this object and must not outlive it.
  client::MenuContent content();
  Thumbnails& thumbnails() { return thumbnails_; }
  // Newest first. A damaged saved game stays in the list, so that the player can see it.
  std::vector<client::MenuSave> saves();
  // Sorted by name: demos of the game folders, and demos that were recorded since they were mounted.
  std::vector<client::MenuDemo> demos() const;
  // The folders below base_folder that look like a game, sorted by name.
  std::vector<client::MenuGameFolder> game_folders() const;
  // HostOptions::sources.
  std::vector<client::MenuGameData> game_data() const;
  // The laboratory's.
  std::vector<client::MenuTechnique> techniques() const;

 private:
  std::vector<client::MenuLevel> levels();
  std::vector<client::MenuEpisode> episodes();
  struct LevelTexts {
    std::string title;
    bool has_flags = false;
  };
  // Texts of a level by its name, "e1m1". The title is empty if the level has none or does not exist. Each
  // level is read only once.
  const LevelTexts& level_texts(const std::string& level);
  Host& host_;
  const GameData& data_;
  Thumbnails thumbnails_;
  std::vector<client::MenuLevel> levels_;  // cached
  std::map<std::string, LevelTexts> texts_;
};

// Returns the names of the files in the write folder that end with `suffix` (".sav"), without it, newest
// first. Empty if the folder cannot be read.
std::vector<std::string> list_written_files(const GameData& data, std::string_view suffix);

}  // namespace temblor::host
