// What the menus show of the world around them, and are told by whoever owns them. Lists are asked for when
// a page opens and after Menu::refresh(); pictures and keys whenever they are drawn.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/images/picture.h"
#include "platform/key.h"
#include "platform/window.h"

namespace temblor::client {

// Names are what console commands take, titles are for people and may be empty. Whatever they hold is shown
// as far as the console's characters can.
struct MenuLevel {
  std::string name, title;
};
struct MenuEpisode {
  std::string title, first_level;
};
struct MenuSave {
  std::string name, level_title;
  double time_s = 0;  // in the level
  int kills = 0, monsters = 0;
};
struct MenuDemo {
  std::string name, title;
};
struct MenuGameFolder {
  std::string name, title;
  bool in_use = false;
};
struct MenuServer {
  std::string address, name, level;
  int players = 0, max_players = 0, ping_ms = 0;
};

// A function that is left out counts as one that has nothing to tell. Pictures must live until the next call
// of the menu.
struct MenuContent {
  std::function<std::vector<MenuLevel>()> levels;
  // Seen from above. Null: there is none, or not yet; asked for the level that is selected only, again in
  // every frame.
  std::function<const formats::Picture*(std::string_view level)> level_picture;
  // With none of these a new game begins in the level "start", where the game lets players choose.
  std::function<std::vector<MenuEpisode>()> episodes;
  std::function<std::vector<MenuSave>()> saves;  // newest first
  std::function<const formats::Picture*(std::string_view save)> save_picture;
  std::function<std::vector<MenuDemo>()> demos;
  std::function<std::vector<MenuGameFolder>()> game_folders;

  std::function<std::vector<MenuServer>()> servers;  // that have answered so far
  std::function<void()> search_servers;              // asks the local network anew

  std::function<int()> displays;
  std::function<std::vector<platform::PixelSize>(int display)> display_sizes;

  std::function<bool()> game_runs;  // one's own or a server's
  std::function<bool()> can_save;
  // What ending the game that runs would lose, a sentence for the player. Empty: nothing.
  std::function<std::string()> unsaved;

  std::function<std::vector<platform::Key>(std::string_view commands)> keys_of;
  std::function<std::string()> clipboard;
  std::function<std::string()> help_text;  // of several lines; those that begin with "# " are headings
};

}  // namespace temblor::client
