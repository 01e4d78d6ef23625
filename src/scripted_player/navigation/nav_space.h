// What a player's box meets in a level, with its moving parts in states of one's choice. Other players,
// monsters and items are not in it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "movement/slide.h"
#include "scripted_player/navigation/level_facts.h"
#include "world/level.h"
#include "world/trace.h"

namespace temblor::player {

// Where a moving part is: in a state, or somewhere (`offset` of each part from its first place).
struct MoverPlace {
  int mover = -1;
  int state = 0;
};

struct Meeting {
  world::Trace trace;
  int mover = -1;  // what stopped it; -1: nothing, or what never moves
};

class NavSpace {
 public:
  // `facts` must outlive it.
  NavSpace(std::shared_ptr<const world::Level> level, const LevelFacts& facts);

  const LevelFacts& facts() const { return *facts_; }
  const world::Level& level() const { return *level_; }

  // The player's box, among what never moves and these.
  Meeting trace(const math::Vec3& start, const math::Vec3& end, std::span<const MoverPlace> movers) const;
  bool is_free(const math::Vec3& place, std::span<const MoverPlace> movers) const;
  // A line as shots go, among what never moves.
  bool is_line_free(const math::Vec3& from, const math::Vec3& to) const;
  // Nor is a door or the like, as it stands at first, before that box, which may be one's own.
  bool is_line_free_of_movers(const math::Vec3& from, const math::Vec3& to, const math::Bounds& target) const;
  world::Contents contents(const math::Vec3& point) const;
  // 0 to 3, as movement has it.
  int water_level(const math::Vec3& place) const;
  bool is_in_lava(const math::Vec3& place) const;
  // The point, and whatever falls from it.
  bool is_above_lava(const math::Vec3& point) const;
  bool is_in_slime(const math::Vec3& place) const;
  // Movers that a player may meet within that box (of his origin), in any of their states.
  void movers_near(const math::Bounds& origins, std::vector<int>& out_movers) const;
  // A part's box, in a state.
  static math::Bounds part_box(const MoverPart& part, int state);
  math::Bounds mover_box(int mover, int state) const;

 private:
  std::shared_ptr<const world::Level> level_;
  const LevelFacts* facts_;
  std::vector<math::Bounds> reach_;  // by mover: all its states, grown by a player
};

// How a player falls or flies, until he stands, swims or is dead.
struct Flight {
  enum class End { kStands, kSwims, kLost };
  math::Vec3 velocity{0.0f};   // at the start
  math::Vec3 direction{0.0f};  // of the wish on the way, level, of length 1 or 0
};
struct FlightEnd {
  Flight::End end = Flight::End::kLost;
  math::Vec3 place{0.0f};
  int mover = -1;  // stands on that
  float time_s = 0;
};
FlightEnd fly(const NavSpace& space, const math::Vec3& from, const Flight& flight,
              std::span<const MoverPlace> movers);

}  // namespace temblor::player
