// When a single player's game is saved without his asking, and by which name. Knows no clock and no game: it
// is told of both.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace temblor::server {

// In turn: a new game does not write over those before it at once.
constexpr std::array<std::string_view, 3> kAutosaveNames = {"autosave", "autosave2", "autosave3"};

class Autosave {
 public:
  // A new game: its saves get another name than those of the one before.
  void begin_game() { name_.clear(); }
  // A game that goes on from a save of this name.
  void begin_loaded(std::string_view name);
  // Before each of them, and when a level follows another. It begins with the first watch(): who still loads
  // it does not play.
  void begin_level();
  void note_save(double now_s);

  struct Player {
    float health = 0;
    bool stands = true;  // on ground or in water: does not fall
  };
  // How the player does; each step.
  void watch(const Player& player, double now_s);

  // Once where a level has begun, then after every `every_s` since the last save; put off while the player
  // falls, and until he has been unhurt for a while: who goes on from there should live on.
  bool is_due(double every_s, double now_s) const;
  // Whether the level was played for long enough that it would be missed.
  bool is_worth_saving(double now_s) const;
  // Of this game's saves: where it has none yet, the one that is not in `folder`, or is oldest there.
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
