// What the menus show of the host and its files.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "client/menu/menu_content.h"
#include "host/menus/thumbnails.h"

namespace temblor::host {

class Host;

class MenuLists {
 public:
  // Both must outlive it.
  MenuLists(Host& host, const GameData& data);
  client::MenuContent content();
  Thumbnails& thumbnails() { return thumbnails_; }

 private:
  std::vector<client::MenuLevel> levels();
  // Empty: it has none, or is not there. Each level is read once.
  const std::string& title_of_level(const std::string& level);
  std::vector<client::MenuSave> saves();
  std::vector<client::MenuDemo> demos() const;
  std::vector<client::MenuGameFolder> game_folders() const;

  Host& host_;
  const GameData& data_;
  Thumbnails thumbnails_;
  std::vector<client::MenuLevel> levels_;  // read once
  std::map<std::string, std::string> titles_;
};

// Files of the last game folder as it is now whose names end so, without that ending; newest first.
std::vector<std::string> written_files(const GameData& data, std::string_view suffix);

}  // namespace temblor::host
