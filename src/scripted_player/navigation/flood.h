// Fills a graph with places and ways.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "scripted_player/navigation/nav_graph.h"

namespace temblor::player {

class Flood {
 public:
  Flood(const NavSpace& space, const GraphLimits& limits, NavGraph& out_graph)
      : space_(space), limits_(limits), graph_(out_graph) {}

  void run(std::span<const math::Vec3> starts);

 private:
  using Movers = std::span<const MoverPlace>;
  // Where a try has led, with the states of movers near in which it does.
  struct Found {
    WayKind kind = WayKind::kWalk;
    math::Vec3 at{0.0f};
    int mover = -1, state = 0;
    bool swims = false;
    float speed = 0, cost = 0;
    std::vector<Demand> demands{};
  };
  struct Step {
    enum class End { kStands, kSwims, kFalls, kBlocked } end = End::kBlocked;
    math::Vec3 at{0.0f};
    int mover = -1;
  };
  using Try = void (Flood::*)(const Place&, const math::Vec3&, Movers, std::vector<Found>&);

  void expand(std::uint32_t i);
  // Every assignment of states to movers that may be met between here and there.
  void with_movers(const Place& place, const math::Bounds& origins);
  void try_all(std::uint32_t i, const Place& place, const math::Vec3& direction, const math::Bounds& origins,
               Try what);
  Step step(const math::Vec3& from, const math::Vec3& to, bool swims, Movers movers) const;
  void try_step(const Place& place, const math::Vec3& direction, Movers movers, std::vector<Found>& io_found);
  void try_fall(const Place& place, const math::Vec3& direction, Movers movers, std::vector<Found>& io_found);
  void try_hop(const Place& place, const math::Vec3& direction, Movers movers, std::vector<Found>& io_found);
  void try_jump(const Place& place, const math::Vec3& direction, Movers movers, std::vector<Found>& io_found);
  bool may_fall_short_into_lava(const math::Vec3& landing, const math::Vec3& direction) const;
  void try_climb_out(const Place& place, const math::Vec3& direction, Movers movers,
                     std::vector<Found>& io_found);
  void try_throw(const Place& place, const math::Vec3& direction, Movers movers,
                 std::vector<Found>& io_found);
  void add_found(Found found, Movers movers, std::vector<Found>& io_found) const;
  void add_rides(std::uint32_t i, const Place& place);
  bool pass_triggers(std::uint32_t i, const Place& place);
  std::optional<std::uint32_t> add_place(const math::Vec3& at, int mover, int state, bool swims);
  void add_way(std::uint32_t from, const Found& found);
  void note_triggers(Place& io_place) const;
  void prefer_open_ground();
  math::Vec3 neighbor(const math::Vec3& at, int dx, int dy) const;

  const NavSpace& space_;
  GraphLimits limits_;
  NavGraph& graph_;
  std::deque<std::uint32_t> open_;
  std::vector<std::vector<MoverPlace>> assignments_;
  bool falls_ = false, is_blocked_ = false;  // what the last tries of a step met
  float fall_z_ = 0;
};

}  // namespace temblor::player
