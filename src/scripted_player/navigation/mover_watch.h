// In which states a level's moving parts are, and which they can get into.
#pragma once

#include <vector>

#include "scripted_player/navigation/level_facts.h"
#include "server/game.h"

namespace temblor::player {

enum class Access {
  kNow,     // it is there, or about to be
  kSelf,    // it gets there by itself, or when somebody comes
  kLocked,  // somebody has to do something elsewhere first
  kNever,
};

class MoverWatch {
 public:
  explicit MoverWatch(const LevelFacts& facts) : facts_(&facts), seen_(facts.movers.size()) {}

  // Once a tick. `items`: the player's, for keys.
  void look(server::Game& io_game, int items);

  // Where it stands; -1: between two states.
  int state(int mover) const { return seen_[static_cast<std::size_t>(mover)].state; }
  bool is_moving(int mover) const { return seen_[static_cast<std::size_t>(mover)].is_moving; }
  // Of its first part.
  const math::Vec3& origin(int mover) const { return seen_[static_cast<std::size_t>(mover)].origin; }
  Access access(int mover, int state) const;
  // The easiest of the states of a mask.
  Access access_any(int mover, std::uint32_t states) const;
  bool is_in(int mover, std::uint32_t states) const;
  bool was_opened(int mover) const { return seen_[static_cast<std::size_t>(mover)].was_opened; }

 private:
  struct Seen {
    bool is_there = false;
    math::Vec3 origin{0.0f}, velocity{0.0f};
    int state = 0, heads_for = -1;
    bool is_moving = false;
    bool has_moved = false;   // ever
    bool was_opened = false;  // ever
    bool waits = false;       // nothing will happen to it by itself
    bool is_gone = false;
  };
  Access access_door(const Mover& mover, const Seen& seen, int state) const;
  Access access_train(const Mover& mover, const Seen& seen) const;

  const LevelFacts* facts_;
  std::vector<Seen> seen_;
  int items_ = 0;
};

}  // namespace temblor::player
