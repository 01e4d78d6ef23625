// Feet: follows a route with the buttons that a player has.
#pragma once

#include <optional>
#include <string>

#include "scripted_player/decisions/dice.h"
#include "scripted_player/decisions/senses.h"
#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/nav_graph.h"
#include "scripted_player/navigation/router.h"

namespace temblor::player {

struct Steering {
  math::Vec3 velocity{0.0f};  // wished, of the world; units/s
  bool jumps = false;
  math::Vec3 look_at{0.0f};
  bool is_free = true;  // a fighter may go his own way now
};

enum class WalkEnd { kGoing, kArrived, kLost };

class Walker {
 public:
  Walker(const NavGraph& graph, const NavSpace& space, const MoverWatch& movers, Router& io_router,
         Dice& io_dice)
      : graph_(&graph), space_(&space), movers_(&movers), router_(&io_router), dice_(&io_dice) {}

  void follow(Route route, double now_s);
  void stop() { route_.reset(); }
  bool has_route() const { return route_.has_value(); }
  // One tick.
  WalkEnd walk(server::Game& io_game, const Self& self, double now_s, Steering& out_steering);
  // Where he is on the route, for messages: "walks to 1 2 3"
  std::string describe() const;
  // The place that the route has passed last.
  std::uint32_t at() const { return route_->places[index_]; }

 private:
  bool is_plain(std::size_t way) const;
  bool is_ready(const Way& way) const;
  void advance(const Self& self, double now_s);
  void pass(double now_s);
  bool is_past(const Self& self);
  void steer_plain(server::Game& io_game, const Self& self, Steering& out);
  void steer_special(server::Game& io_game, const Self& self, Steering& out);
  void steer_ride(const Self& self, const Way& way, Steering& out);
  void steer_jump(server::Game& io_game, const Self& self, const Way& way, Steering& out);
  void steer_in_air(const Self& self, const math::Vec3& landing, Steering& out) const;
  bool has_gone_without(const Place& from) const;
  bool waits_for_mover(const Way& way) const;
  bool is_stuck(const Self& self, double now_s, bool waits);
  WalkEnd lose(float blame);

  const NavGraph* graph_;
  const NavSpace* space_;
  const MoverWatch* movers_;
  Router* router_;
  Dice* dice_;
  std::optional<Route> route_;
  std::size_t index_ = 0;  // of the place passed last
  double passed_s_ = 0;    // when
  bool is_impatient_ = false;
  bool was_in_air_ = false;
  bool charges_ = false;  // a jump's run-up has begun
  std::optional<math::Vec3> run_up_;
  math::Vec3 watched_from_{0.0f};  // for the stuck
  double watched_since_s_ = 0;
  double wriggles_until_s_ = 0;
  math::Vec3 wriggle_{0.0f};
  int stuck_ = 0;
};

}  // namespace temblor::player
