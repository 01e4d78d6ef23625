// The menus' view of the world around them, provided by their owner as functions. Lists are read when a page
// opens and after Menu::refresh(); pictures and key bindings whenever they are drawn. So the menus need no
// files or sockets, and tests provide invented content.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/images/picture.h"
#include "platform/key.h"
#include "platform/window.h"

namespace temblor::client {

// Names are arguments of console commands; titles are for people and may be empty. Both may contain any
// bytes: the menu replaces what the console's characters cannot show, and quotes names in commands.
struct MenuLevel {
  std::string name, title;
  bool has_flags = false;  // capture the flag can be played in it
};
struct MenuEpisode {
  std::string title, first_level;
  std::string level_title = {};  // of the first level
};
struct MenuSave {
  // The file's name, and the name that the player has given; empty if none.
  std::string name, title;
  std::string level_title;
  std::string date;  // "2026-11-26 07:02"; empty if unknown
  int skill = -1;    // 0 to 3; -1 if unknown
  // Played in the level, seconds.
  double time_s = 0;
  int kills = 0, monsters = 0;
};
// The number of characters of MenuSave::title that a file has room for.
constexpr std::size_t kMaxSaveTitle = 22;
// A room and an overview of a level; null if there is none, or none yet.
struct MenuLevelPictures {
  const formats::Picture *room = nullptr, *overview = nullptr;
};
struct MenuDemo {
  std::string name, title;
};
struct MenuGameFolder {
  std::string name, title;
  bool in_use = false;
};
// Game data: the shipped game, or one that the player has installed. `name` is the argument of `basedir`.
struct MenuGameData {
  std::string name, title, folder;
  bool in_use = false;
};
// A way to draw the level. `name` is the value of `r_technique`, `summary` a sentence.
struct MenuTechnique {
  std::string name, title, summary;
  bool in_use = false;
};
struct MenuServer {
  std::string address, name, level;
  int players = 0, max_players = 0, ping_ms = 0;
};

// An empty function counts as one that returns an empty value. Pictures must live until the next call of the
// menu.
struct MenuContent {
  std::function<std::vector<MenuLevel>()> levels;
  // Called in every frame, for the selected level only.
  std::function<MenuLevelPictures(std::string_view level)> level_pictures;
  // Whether the game has the Tremor, a weapon of the shipped game.
  std::function<bool()> has_tremor;
  // The places where a new game can start. Without them, it starts in the level "start", where the player
  // chooses.
  std::function<std::vector<MenuEpisode>()> episodes;
  // Saved games, newest first, and their screenshots.
  std::function<std::vector<MenuSave>()> saves;
  std::function<const formats::Picture*(std::string_view save)> save_picture;
  std::function<std::vector<MenuDemo>()> demos;
  std::function<std::vector<MenuGameFolder>()> game_folders;
  std::function<std::vector<MenuGameData>()> game_data;

  // The techniques of the laboratory; none: no laboratory.
  std::function<std::vector<MenuTechnique>()> techniques;

  // The servers that have answered so far.
  std::function<std::vector<MenuServer>()> servers;
  // Starts a new search of the local network.
  std::function<void()> search_servers;

  // The number of monitors, and the sizes that each offers.
  std::function<int()> displays;
  std::function<std::vector<platform::PixelSize>(int display)> display_sizes;

  // Whether a game runs, locally or on a server, and whether it can be saved.
  std::function<bool()> game_runs;
  std::function<bool()> can_save;
  // Whether the player watches a demo; not those behind the menu.
  std::function<bool()> demo_plays;
  // A sentence about what the player would lose if the game ended now; empty for nothing.
  std::function<std::string()> unsaved;

  // The keys that run exactly these commands.
  std::function<std::vector<platform::Key>(std::string_view commands)> find_keys;
  std::function<std::string()> clipboard;
  // The text of the help page, in lines; those that begin with "# " are headings.
  std::function<std::string()> help_text;
};

}  // namespace temblor::client
