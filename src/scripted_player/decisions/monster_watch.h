// Monsters that do not work: in walls, or idle before their enemy's eyes.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "scripted_player/navigation/level_facts.h"
#include "server/game.h"

namespace temblor::player {

class MonsterWatch {
 public:
  explicit MonsterWatch(server::Game& io_game);

  // A few times a second.
  void look(server::Game& io_game, double now_s);
  std::vector<std::string> stuck() const { return {stuck_.begin(), stuck_.end()}; }
  std::vector<std::string> idle() const;

 private:
  struct Watched {
    std::string name;
    math::Vec3 at{0.0f};  // where it was when it last did something
    double since_s = 0;   // when that was
    float health = 0;
    int stuck_looks = 0;         // in a row
    std::set<float> doings{};    // sequences of frames that it was in since then
    std::set<float> finishes{};  // of attacks
  };
  bool fights(server::Game& io_game, const server::Edict& monster) const;
  bool is_about_something(server::Game& io_game, const server::Edict& monster) const;

  GameFields fields_;
  std::map<std::uint32_t, Watched> watched_;
  std::set<std::string> stuck_;
  std::map<std::string, std::string> idle_;  // by monster
};

}  // namespace temblor::player
