// The space that a player can occupy in a level, for any combination of states of its movers.
//
// Traces use the player's clip hull, as real movement does, against the world, brush models that never move,
// and the movers that the caller places. Other players, monsters, and items are ignored, because they are
// elsewhere by the time a player gets there. A "place" below is a player's origin, 24 units above its feet.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "movement/slide.h"
#include "scripted_player/navigation/level_facts.h"
#include "world/hull_cells.h"
#include "world/level.h"
#include "world/trace.h"

namespace temblor::player {

// A mover in one of its states.
struct MoverPlace {
  int mover = -1;
  int state = 0;
};

struct NavTrace {
  world::Trace trace;
  // The mover that stopped the trace; -1: nothing did, or something that never moves.
  int mover = -1;
};

class NavSpace {
 public:
  // `facts` must outlive it.
  NavSpace(std::shared_ptr<const world::Level> level, const LevelFacts& facts);

  const LevelFacts& facts() const { return *facts_; }
  const world::Level& level() const { return *level_; }

  // Traces the player's box through everything that never moves and through `movers`. Movers that are not
  // listed are ignored.
  NavTrace trace(const math::Vec3& start, const math::Vec3& end, std::span<const MoverPlace> movers) const;
  // Returns whether a player at that place is not inside something solid.
  bool is_free(const math::Vec3& place, std::span<const MoverPlace> movers) const;
  // Returns whether a shot passes between two points. Movers do not block it.
  bool is_line_free(const math::Vec3& from, const math::Vec3& to) const;
  // Returns whether no brush model outside `target` blocks a shot, with all movers in their first state. The
  // target may be a brush model itself.
  bool is_line_free_of_movers(const math::Vec3& from, const math::Vec3& to, const math::Bounds& target) const;
  // Contents of the world; currents count as water.
  world::Contents contents(const math::Vec3& point) const;
  // Depth of a player at that place: 0 dry, 1 feet, 2 waist, 3 eyes (movement::Water).
  int water_level(const math::Vec3& place) const;
  // Returns whether the feet of a player at that place are in lava.
  bool is_in_lava(const math::Vec3& place) const;
  // Returns whether a point that falls straight down from there ends in lava.
  bool is_above_lava(const math::Vec3& point) const;
  bool is_in_slime(const math::Vec3& place) const;
  // Sets `out_movers` to the movers that a player with its origin in that box may touch, in any of their
  // states.
  void movers_near(const math::Bounds& origins, std::vector<int>& out_movers) const;
  // Returns a part's box in that state.
  static math::Bounds part_box(const MoverPart& part, int state);
  // Returns the box around all parts in that state.
  math::Bounds mover_box(int mover, int state) const;

 private:
  // The same as world::trace_box_through_model() for the player's box and the world.
  world::Trace trace_world(const math::Vec3& start, const math::Vec3& end) const;

  std::shared_ptr<const world::Level> level_;
  const LevelFacts* facts_;
  // From a player's origin to that of the hull, whose box may be higher (world::choose_hull()).
  math::Vec3 to_hull_;
  // The world's hulls. Queries fill them, so one thread at a time may use a NavSpace.
  mutable world::HullCells player_hull_, point_hull_;
  // By mover: the origins at which a player may touch it in any of its states.
  std::vector<math::Bounds> reach_;
  // The same by static model and static box.
  std::vector<math::Bounds> static_model_reach_, static_box_reach_;
};

// A jump, fall, or push.
struct Flight {
  enum class End { kStands, kSwims, kLost };
  // Initial velocity in units/s.
  math::Vec3 velocity{0.0f};
  // Direction in which the player steers in the air: horizontal, of length 1, or 0 for none.
  math::Vec3 direction{0.0f};
};
struct FlightEnd {
  // kLost: in lava, or still in the air after a few seconds.
  Flight::End end = Flight::End::kLost;
  math::Vec3 place{0.0f};
  // The mover that the player stands on; -1: none.
  int mover = -1;
  float time_s = 0;
};
// Simulates a flight with the real movement code (movement::slide) at 72 ticks per second, until the player
// stands or swims. Pushes on the way (trigger_push) set the velocity.
FlightEnd fly(const NavSpace& space, const math::Vec3& from, const Flight& flight,
              std::span<const MoverPlace> movers);

}  // namespace temblor::player
