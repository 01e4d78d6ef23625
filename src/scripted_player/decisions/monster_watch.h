// Finds monsters that do not work: inside walls, or idle in sight of their enemy.
//
// A monster is idle if for five seconds it sees its enemy but neither moves, attacks, is hurt, nor changes
// its animation.
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

  // Checks all monsters. Call four times per second.
  void look(server::Game& io_game, double now_s);
  // Both return messages: the monster and its position.
  std::vector<std::string> stuck() const { return {stuck_.begin(), stuck_.end()}; }
  std::vector<std::string> idle() const;

 private:
  struct Watched {
    std::string name;
    // Position, time, and health when it last did something.
    math::Vec3 at{0.0f};
    double since_s = 0;
    float health = 0;
    // Consecutive checks inside a wall.
    int stuck_looks = 0;
    // First frames of the animations that it has played since then, and values of attack_finished. More than
    // one value means that it did something.
    std::set<float> animations{};
    std::set<float> attack_times{};
  };
  bool fights(server::Game& io_game, const server::Edict& monster) const;
  bool plays_action(server::Game& io_game, const server::Edict& monster) const;

  GameFields fields_;
  std::map<std::uint32_t, Watched> watched_;
  std::set<std::string> stuck_;
  // Messages by monster.
  std::map<std::string, std::string> idle_;
};

}  // namespace temblor::player
