// Follows a route by steering: turns the links of the route into wanted velocities and jumps, tick by tick.
//
// Links on which the player walks or swims are "plain": it heads for the farthest place ahead that it can
// reach in a straight line, and may skip places. All other links (jumps, drops, lifts, ...) are "special" and
// passed one by one. A link that fails or takes too long is penalized (router.h), so that the next route
// avoids it.
#pragma once

#include <optional>
#include <string>

#include "scripted_player/decisions/random.h"
#include "scripted_player/decisions/senses.h"
#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/nav_graph.h"
#include "scripted_player/navigation/router.h"

namespace temblor::player {

struct Steering {
  // Wanted velocity in world space, in units/s.
  math::Vec3 velocity{0.0f};
  bool jumps = false;
  math::Vec3 look_at{0.0f};
  // Combat may override the velocity. Not during a jump or a ride.
  bool is_free = true;
};

enum class WalkResult { kGoing, kArrived, kLost };

class Walker {
 public:
  // All must outlive it.
  Walker(const NavGraph& graph, const NavSpace& space, const MoverWatch& movers, Router& io_router,
         Random& io_dice)
      : graph_(&graph), space_(&space), movers_(&movers), router_(&io_router), dice_(&io_dice) {}

  void follow(Route route, double now_s);
  void stop() { route_.reset(); }
  bool has_route() const { return route_.has_value(); }
  // Steers one tick. kLost: the player is off the route, or a link does not work; the route is dropped.
  WalkResult walk(server::Game& io_game, const Self& self, double now_s, Steering& out_steering);
  // Describes the current link, for messages: "walks from 1 2 3 to 4 5 6".
  std::string describe() const;

 private:
  bool is_plain(std::size_t link) const;
  bool is_ready(const Link& link) const;
  void advance(const Self& self, double now_s);
  void start_link(double now_s);
  bool has_finished_link(const Self& self);
  void steer_plain(server::Game& io_game, const Self& self, Steering& out);
  void steer_special(server::Game& io_game, const Self& self, Steering& out);
  void steer_ride(const Self& self, const Link& link, Steering& out);
  void steer_jump(server::Game& io_game, const Self& self, const Link& link, Steering& out);
  void steer_in_air(const Self& self, const math::Vec3& landing, Steering& out) const;
  bool missed_ride(const Place& from) const;
  bool waits_for_mover(const Link& link) const;
  bool is_in_way(const Link& link, const math::Vec3& at) const;
  int count_steps_out_of_way(const Self& self, const Link& link) const;
  void wait_for_mover(const Self& self, const Link& link, bool goes_back, Steering& out);
  bool is_stuck(const Self& self, double now_s, bool waits);
  WalkResult give_up_route(float penalize_link);

  const NavGraph* graph_;
  const NavSpace* space_;
  const MoverWatch* movers_;
  Router* router_;
  Random* dice_;
  std::optional<Route> route_;
  // Index in the route of the last place that was passed, and the time of that.
  std::size_t index_ = 0;
  double passed_s_ = 0;
  // Places of the route that the player has gone back. Limited: two players could chase each other to and
  // fro.
  int steps_back_ = 0;
  // Has waited so long that movers near the link no longer matter.
  bool is_impatient_ = false;
  bool was_in_air_ = false;
  // A jump's run-up has begun; where it begins.
  bool is_running_up_ = false;
  std::optional<math::Vec3> run_up_;
  // The player is stuck if it stays near this point.
  math::Vec3 watched_from_{0.0f};
  double watched_since_s_ = 0;
  // Moves with this velocity to get unstuck.
  double wriggles_until_s_ = 0;
  math::Vec3 wriggle_{0.0f};
  // How often it was stuck on this route.
  int stuck_ = 0;
};

}  // namespace temblor::player
