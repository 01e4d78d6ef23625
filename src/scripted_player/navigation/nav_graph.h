// Where a player can stand or swim in a level, and how he gets from one such place to the next: found by
// flooding from where he starts, with the traces that move real players.
//
// Method: places lie in a grid of cells of kCell_units; from each place every step, drop, jump, ride and
// passage is tried that a player could do there. Where doors, lifts or trains are near, it is tried with them
// in each of their states, and what a way asks of them stands with it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "scripted_player/navigation/nav_space.h"

namespace temblor::player {

constexpr int kCell_units = 16;

enum class WayKind : std::uint8_t { kWalk, kSwim, kDrop, kHop, kJump, kClimbOut, kRide, kTeleport, kPush };

// A mover has to be in one of the states of the mask (bit n: state n).
struct Demand {
  int mover = -1;
  std::uint32_t states = 0;
};

struct Way {
  std::uint32_t to = 0;
  WayKind kind = WayKind::kWalk;
  float cost = 0;   // about a player's units on foot
  float speed = 0;  // jumps: level speed at the start
  std::array<Demand, 2> demands{};
};

struct Place {
  math::Vec3 at{0.0f};  // of the player's origin
  int mover = -1;       // stands on it, in that state
  int state = 0;
  bool swims = false;
  bool is_end = false;  // whoever is here leaves the level
  float penalty = 0;    // of being here: slime, things that hurt
  std::vector<Way> ways;
};

struct GraphLimits {
  std::size_t places = 400'000;
};

class NavGraph {
 public:
  NavGraph(const NavSpace& space, std::span<const math::Vec3> starts, const GraphLimits& limits = {});

  const std::vector<Place>& places() const { return places_; }
  const Place& place(std::uint32_t i) const { return places_[i]; }
  std::size_t ways() const;
  // The place that somebody is at; -1: none is near.
  int nearest(const math::Vec3& at, float within_units = 64) const {
    return nearest(at, within_units, [](const Place&) { return true; });
  }
  // Only among those that are there now: a place on a lift that is elsewhere is none.
  int nearest(const math::Vec3& at, float within_units, base::FunctionRef<bool(const Place&)> is_there) const;
  // Places where a player's box, grown by `grown`, meets that box.
  std::vector<std::uint32_t> touching(const math::Bounds& box, float grown) const;

 private:
  friend class Flood;
  std::vector<Place> places_;
  std::vector<std::vector<std::uint32_t>> cells_;  // of the grid, row by row
  math::Vec3 low_{0.0f};
  int width_ = 0, height_ = 0;

  // Of the grid's `rows`, which begin at `low`, the one there; outside of it the nearest.
  static int row_of(float along, float low, int rows);
  std::size_t cell_of(const math::Vec3& at) const;
};

}  // namespace temblor::player
