// The graph of all places in a level where a player can stand or swim, and of the links between them.
//
// Method: flooding (flood.h). Places lie in the cells of a horizontal grid, at most one per cell, floor, and
// mover state. The flood starts where players start, and tries from each place every step, drop, jump, ride,
// and teleporter. It uses the real movement code, so a link exists exactly if a player can follow it. Near
// movers, each attempt is repeated with the movers in each of their states; the states in which it works
// become conditions of the link:
//
//   place ---kWalk, if door 3 is open---> place ---kRide, if lift 5 is up---> place on lift 5 in state 1
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "scripted_player/navigation/nav_space.h"

namespace temblor::player {

// Width of a grid cell: half of a player.
constexpr int kCell_units = 16;

// kHop jumps onto something directly ahead, kJump across a gap. kPush is a flight that a trigger_push causes.
enum class LinkKind : std::uint8_t { kWalk, kSwim, kDrop, kHop, kJump, kClimbOut, kRide, kTeleport, kPush };

// A mover has to be in one of the states of the mask (bit n: state n).
struct MoverCondition {
  // -1: no condition.
  int mover = -1;
  std::uint32_t states = 0;
};

// A directed edge of the graph.
struct Link {
  // Index of the place that it leads to.
  std::uint32_t to = 0;
  LinkKind kind = LinkKind::kWalk;
  // In units that a player walks in the same time, plus penalties for danger.
  float cost = 0;
  // Horizontal speed at takeoff, in units/s; only for kJump.
  float speed = 0;
  // Both must be met.
  std::array<MoverCondition, 2> conditions{};
};

struct Place {
  // The player's origin.
  math::Vec3 at{0.0f};
  // The mover that the player stands on, and its state; -1: none.
  int mover = -1;
  int state = 0;
  bool swims = false;
  // Touches a trigger_changelevel, so the player leaves the level and no links lead on.
  bool is_exit = false;
  // Added to the cost of each link that leads here: slime and triggers that hurt.
  float penalty = 0;
  std::vector<Link> links;
};

struct GraphLimits {
  std::size_t places = 400'000;
};

class NavGraph {
 public:
  // Floods from `starts`, which are player origins. At the limit, it adds no more places.
  NavGraph(const NavSpace& space, std::span<const math::Vec3> starts, const GraphLimits& limits = {});

  const std::vector<Place>& places() const { return places_; }
  const Place& place(std::uint32_t i) const { return places_[i]; }
  std::size_t link_count() const;
  // Returns the place nearest to a player at `at`; -1 if there is none within `within_units`. Height
  // counts 1.5 times.
  int find_nearest(const math::Vec3& at, float within_units = 64) const {
    return find_nearest(at, within_units, [](const Place&) { return true; });
  }
  // The same, but only among the places for which `is_there` returns true: a place on a lift exists only
  // while the lift is there.
  int find_nearest(const math::Vec3& at, float within_units,
                   base::FunctionRef<bool(const Place&)> is_there) const;
  // Returns, in ascending order, the places where the box of a player, expanded by `grown` units, touches
  // `box`.
  std::vector<std::uint32_t> find_touching(const math::Bounds& box, float grown) const;

 private:
  friend class Flood;
  std::vector<Place> places_;
  // Places in each cell of the grid, row by row (y, then x). low_ is the grid's corner.
  std::vector<std::vector<std::uint32_t>> cells_;
  math::Vec3 low_{0.0f};
  int width_ = 0, height_ = 0;

  // Returns the row or column of a coordinate, clamped to the grid. `low` is where row 0 begins.
  static int grid_row(float along, float low, int rows);
  std::size_t cell_index(const math::Vec3& at) const;
};

}  // namespace temblor::player
