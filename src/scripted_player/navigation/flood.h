// Builds a NavGraph by flooding: a breadth-first search whose edges are movements that a player can make.
//
//   open_ -> expand(place)
//              each of 8 directions:  step -> blocked?  hop, or climb out of water
//                                          -> falls?    drop, or jump in 3 directions at 3 speeds
//              on a mover:            ride to its other states
//              in a teleporter, push: arrive at its end
//
// Each attempt is repeated for every assignment of states to the movers nearby. Attempts with the same result
// are merged into one candidate whose conditions accept all their states; a condition that accepts every
// state is dropped.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "scripted_player/navigation/nav_graph.h"

namespace temblor::player {

class Flood {
 public:
  // `space` and `out_graph` must outlive it.
  Flood(const NavSpace& space, const GraphLimits& limits, NavGraph& out_graph)
      : space_(space), limits_(limits), graph_(out_graph) {}

  // Fills the graph with everything that can be reached from the starts, which first fall to the floor.
  void run(std::span<const math::Vec3> starts);

 private:
  using Movers = std::span<const MoverPlace>;
  // A link that works, before its target has become a place of the graph.
  struct Candidate {
    LinkKind kind = LinkKind::kWalk;
    math::Vec3 at{0.0f};
    // The mover that the player then stands on; -1: none.
    int mover = -1, state = 0;
    bool swims = false;
    float speed = 0, cost = 0;
    // One for each mover nearby.
    std::vector<MoverCondition> conditions{};
  };
  struct Step {
    enum class End { kStands, kSwims, kFalls, kBlocked } end = End::kBlocked;
    math::Vec3 at{0.0f};
    int mover = -1;
  };
  using Try = void (Flood::*)(const Place&, const math::Vec3&, Movers, std::vector<Candidate>&);

  // Adds all links that leave a place.
  void expand(std::uint32_t i);
  // Sets assignments_ to all combinations of states of the movers that a player with its origin in that box
  // may touch.
  void assign_mover_states(const Place& place, const math::Bounds& origins);
  // Makes an attempt for each combination.
  void try_all(std::uint32_t i, const Place& place, const math::Vec3& direction, const math::Bounds& origins,
               Try attempt);
  Step step(const math::Vec3& from, const math::Vec3& to, bool swims, Movers movers) const;
  // Each of these adds a candidate if the movement works. try_step() and try_fall() take the offset to the
  // next cell, the others a horizontal unit vector.
  void try_step(const Place& place, const math::Vec3& offset, Movers movers,
                std::vector<Candidate>& io_found);
  void try_fall(const Place& place, const math::Vec3& offset, Movers movers,
                std::vector<Candidate>& io_found);
  void try_hop(const Place& place, const math::Vec3& direction, Movers movers,
               std::vector<Candidate>& io_found);
  void try_jump(const Place& place, const math::Vec3& direction, Movers movers,
                std::vector<Candidate>& io_found);
  // Returns whether a jump that is a little too short ends in lava.
  bool may_fall_short_into_lava(const math::Vec3& landing, const math::Vec3& direction) const;
  void try_climb_out(const Place& place, const math::Vec3& direction, Movers movers,
                     std::vector<Candidate>& io_found);
  void try_throw(const Place& place, const math::Vec3& direction, Movers movers,
                 std::vector<Candidate>& io_found);
  void add_candidate(Candidate found, Movers movers, std::vector<Candidate>& io_found) const;
  void add_rides(std::uint32_t i, const Place& place);
  // Adds the links of a teleporter or push. Returns true if there is one, because a player cannot then walk
  // on from there.
  bool follow_triggers(std::uint32_t i, const Place& place);
  // Returns the place there, new or known; nothing if the graph is full.
  std::optional<std::uint32_t> add_place(const math::Vec3& at, int mover, int state, bool swims);
  void add_link(std::uint32_t from, const Candidate& found);
  void apply_triggers(Place& io_place) const;
  void penalize_narrow_places();
  // Returns the center of the neighboring cell, at the same height.
  math::Vec3 neighbor(const math::Vec3& at, int dx, int dy) const;

  const NavSpace& space_;
  GraphLimits limits_;
  NavGraph& graph_;
  // Places that are not expanded yet.
  std::deque<std::uint32_t> open_;
  std::vector<std::vector<MoverPlace>> assignments_;
  // Obstacles that the last steps met, in any assignment: a drop, a wall, and the height where the highest
  // drop ends.
  bool falls_ = false, is_blocked_ = false;
  float fall_z_ = 0;
};

}  // namespace temblor::player
