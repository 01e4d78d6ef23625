// Decides when a single player's game is saved automatically, and under which name. It knows neither a clock
// nor a game: callers pass in what it needs.
//    level begins --0.5 s--> first save --every_s--> next save ...
// Saves are postponed while the player falls, and all but the first after it was hurt.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace temblor::server {

// Used in turn, so that a new game does not overwrite the last one's autosave at once.
constexpr std::array<std::string_view, 3> kAutosaveNames = {"autosave", "autosave2", "autosave3"};

class Autosave {
 public:
  // A new game: its saves get another name than those of the previous game.
  void begin_game() { name_.clear(); }
  // A game that continues from the save of this name.
  void begin_loaded(std::string_view name);
  // Called when any level starts, before begin_game() or begin_loaded(). Its time starts with the first
  // watch(), because a player who still loads the level does not play yet.
  void begin_level();
  // The game was saved, automatically or on request.
  void note_save(double now_s);

  struct Player {
    float health = 0;
    bool stands = true;  // on ground or in water: does not fall
  };
  // The player's state in this step.
  void watch(const Player& player, double now_s);

  // Due on arrival in a level, and `every_s` after the last save. Postponed while the player falls; later
  // saves also until it has not been hurt for a while: a player who resumes from there should survive.
  bool is_due(double every_s, double now_s) const;
  // Whether the level was played for long enough that the player would miss it.
  bool is_worth_saving(double now_s) const;
  // The name of this game's saves. The first call chooses one: a name without a file in `folder`, or else the
  // one with the oldest file.
  std::string choose_name(const std::filesystem::path& folder);

 private:
  std::string name_;  // empty: not chosen yet
  std::optional<double> began_s_;
  double saved_s_ = 0, hurt_s_ = 0;
  float health_ = 0;
  bool was_saved_ = false;  // in this level
  bool stands_ = true;
};

}  // namespace temblor::server
