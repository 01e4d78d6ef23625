// Tracks the movers of a level: which state each is in now, and which states it can get into.
//
// A mover is in a state if its leader's origin is within 2 units of the state's position (trains: 12, because
// they pass their corners without a stop). Between two states its state is -1. Mover indices refer to
// LevelFacts::movers.
#pragma once

#include <vector>

#include "scripted_player/navigation/level_facts.h"
#include "server/game.h"

namespace temblor::player {

// How easily a mover gets into a state, from the easiest to the hardest. The order matters: access_any()
// takes the minimum.
enum class Access {
  // It is in the state or on its way there.
  kNow,
  // It gets there without help, or when a player comes near.
  kAutomatic,
  // A player has to do something elsewhere first.
  kLocked,
  kNever,
};

class MoverWatch {
 public:
  // `facts` must outlive it.
  explicit MoverWatch(const LevelFacts& facts) : facts_(&facts), seen_(facts.movers.size()) {}

  // Observes all movers. Call once per tick. `items` are the player's, because keys open doors.
  void look(server::Game& io_game, int items);

  // The current state; -1 between two states.
  int state(int mover) const { return seen_[static_cast<std::size_t>(mover)].state; }
  bool is_moving(int mover) const { return seen_[static_cast<std::size_t>(mover)].is_moving; }
  // The origin of its first part.
  const math::Vec3& origin(int mover) const { return seen_[static_cast<std::size_t>(mover)].origin; }
  Access access(int mover, int state) const;
  // Returns the easiest access to any state of the mask (bit n: state n). kNever for an empty mask.
  Access access_any(int mover, std::uint32_t states) const;
  // Returns whether the mover is in a state of the mask. A mover that game code has removed is in all states.
  bool is_in(int mover, std::uint32_t states) const;
  // Returns whether it has ever been in its last state.
  bool was_opened(int mover) const { return seen_[static_cast<std::size_t>(mover)].was_opened; }

 private:
  struct MoverStatus {
    // Observed at least once.
    bool is_known = false;
    math::Vec3 origin{0.0f}, velocity{0.0f};
    // The current state, and the one that its velocity points to; -1: none.
    int state = 0, heads_for = -1;
    bool is_moving = false;
    // At any time since the level started.
    bool has_moved = false, was_opened = false;
    // No think function is pending, so it stays where it is until something activates it.
    bool is_idle = false;
    // Removed by game code, or no longer solid.
    bool is_gone = false;
  };
  Access access_door(const Mover& mover, const MoverStatus& seen, int state) const;
  Access access_train(const Mover& mover, const MoverStatus& seen) const;

  const LevelFacts* facts_;
  // By mover.
  std::vector<MoverStatus> seen_;
  int items_ = 0;
};

}  // namespace temblor::player
