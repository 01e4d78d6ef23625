// A player's decisions: turns the map of the level and the state of the game into one move per tick.
//
//   choose_task (planner)  ->  Task  ->  walk its route (walker)  ->  perform it  ->  next task
//        ^                                     |
//        '-- blocked, lost, interrupted -------'
//
// On the way, an item may be worth a detour (item_detours.cpp), the fighter may take over movement and view,
// and a player that has left the known places recovers (recovery.cpp). The brain knows the entities of the
// level and where monsters are, like a person who has played it often, but it acts only by buttons, view
// angles, and impulses.
//
//   file                   part of Brain
//   brain.cpp              the tick: state, task, fight, move
//   choose_task.cpp        waypoints, secrets, exits, and giving up
//   item_detours.cpp       items on the way, in a level with an exit
//   deathmatch_items.cpp   items in a deathmatch
//   tour.cpp               tour stops
//   recovery.cpp           away from all known places
#pragma once

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "net/protocol/client_message.h"
#include "scripted_player/decisions/fighter.h"
#include "scripted_player/decisions/view.h"
#include "scripted_player/decisions/walker.h"
#include "scripted_player/navigation/level_map.h"
#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/planner.h"
#include "scripted_player/navigation/router.h"

namespace temblor::player {

struct ItemChoice;

struct BrainSetup {
  // Seed of all random decisions.
  std::uint64_t seed = 1;
  // The player's slot on the server.
  std::size_t slot = 0;
  // Visits every secret before the exit.
  bool visits_secrets = false;
  // Fights monsters; with fights_players, other players too, as in a deathmatch.
  bool fights = true, fights_players = false;
  // Visits the tour stops of the level, after the waypoints.
  bool visits_stops = false;
  // Collects items forever instead of leaving: deathmatch.
  bool roams = false;
  // Visited first, in this order.
  std::vector<math::Vec3> waypoints{};
  // Takes the exit to this level; empty: the cheapest to reach.
  std::string exit_map{};
  // Gives up if no task can be reached for this long.
  double patience_s = 20;
};

class Brain {
 public:
  // `map` must outlive it.
  Brain(const LevelMap& map, server::Game& io_game, const BrainSetup& setup);

  // Adapts to a restart of the level: the same entities in a new game.
  void restart(server::Game& io_game);
  // Decides the move for this tick. Call once per tick. `view_deg` are the angles that the server has forced,
  // if any.
  net::Move think(server::Game& io_game, std::optional<math::Vec3> view_deg, double now_s);

  // Returns true once if the player is in a dead end and wants to restart the level with the command "kill".
  bool wants_restart() { return std::exchange(wants_restart_, false); }
  bool has_given_up() const { return has_given_up_; }
  // Why it gave up, and what it could not reach: one line each, without duplicates.
  const std::vector<std::string>& problems() const { return problems_; }
  // Describes the current task, for messages.
  std::string describe() const;
  // One line per death: killer and place.
  const std::vector<std::string>& deaths() const { return deaths_; }
  // Returns whether that mover was fully open at any time since the level started.
  bool saw_open(int mover) const { return movers_.was_opened(mover); }

 private:
  // First the route of the task, then the act itself.
  enum class Phase { kWalk, kAct };

  // Each of these returns a task with a route from the place `at`; nothing if there is none or it cannot be
  // reached.
  std::optional<Task> choose_next_task(std::uint32_t at);
  std::optional<Task> resume_planned_task(std::uint32_t at);
  std::optional<Task> plan_waypoint(std::uint32_t at);
  std::optional<Task> plan_stop(std::uint32_t at);
  std::optional<Task> plan_button(std::uint32_t at, const Stop& stop);
  std::optional<Task> plan_deathmatch_item(std::uint32_t at);
  std::optional<Task> plan_secret(std::uint32_t at);
  std::optional<Task> plan_exit(std::uint32_t at);
  std::optional<Task> plan_detour(server::Game& io_game, const Self& self, std::uint32_t at);
  std::optional<Task> make_take_task(server::Game& io_game, const ItemChoice& item, std::uint32_t at);
  // Returns the facts that a plan depends on: which states of movers are locked, and the keys. A plan is
  // reused while they stay the same.
  std::vector<bool> list_premises(int items) const;

  void start_task(Task task, double now_s);
  void drop_task() {
    task_.reset();
    walker_.stop();
  }
  void choose_task(const Self& self, double now_s);
  // Continues, starts, or ends the task and steers for it.
  void advance_task(server::Game& io_game, const Self& self, double now_s, Steering& out);
  void perform_task(server::Game& io_game, const Self& self, double now_s, Steering& out);
  bool is_done(server::Game& io_game, const Self& self) const;
  bool is_route_blocked() const;
  bool should_fight_first(double now_s);
  // Records that the task did not work.
  void abandon_task(const Self& self);

  void visit(const Self& self, double now_s, Steering& out);
  void finish_stop();

  // Returns the place that the player is at, preferably one that exists in the current state of its mover;
  // -1: none.
  int nearest_place(const Self& self) const;
  void return_to_graph(server::Game& io_game, const Self& self, double now_s, Steering& out);
  math::Vec3 choose_heading(server::Game& io_game, const Self& self);
  void request_restart(const Self& self);

  net::Move make_move(const Self& self, const Steering& steering);
  void record_death(server::Game& io_game, const Self& self);
  void report_problem(const std::string& text);

  const LevelMap* map_;
  server::Game* game_;
  BrainSetup setup_;
  Random dice_;
  MoverWatch movers_;
  Router router_;
  Planner planner_;
  Walker walker_;
  Fighter fighter_;
  View view_;

  // The current task, and the last one that was planned, which is resumed after a detour while its premises
  // hold.
  std::optional<Task> task_, planned_;
  std::vector<bool> planned_on_;
  // The task is a detour to an item.
  bool is_side_task_ = false;
  Phase phase_ = Phase::kWalk;
  // Times of the last change of phase, search for items, planning, and check of the route.
  double phase_since_s_ = 0, looked_for_items_s_ = 0, planned_s_ = -10, checked_route_s_ = 0;
  // Since when no task can be reached.
  std::optional<double> stalled_since_s_;
  double settled_since_s_ = 0, fights_first_until_s_ = -100;

  // Secrets that cannot be reached, and how often no route to a secret was found.
  std::set<std::uint32_t> abandoned_secrets_;
  std::map<std::uint32_t, int> secret_failures_;
  bool waits_for_secret_ = false, wants_restart_ = false;

  static constexpr int kMaxDeadEnds = 3;
  int dead_ends_ = 0;
  // Since when no known place is near, and where it goes meanwhile.
  std::optional<double> lost_since_s_;
  math::Vec3 heading_{0.0f};
  double heading_until_s_ = 0;

  // Detours to each item so far.
  std::map<std::uint32_t, int> item_attempts_;
  // Indices of the next waypoint and tour stop.
  std::size_t waypoint_ = 0, stop_ = 0;
  // The button of the current stop has been pressed.
  bool has_pressed_ = false;
  // The last items of a deathmatch, not visited again yet.
  std::deque<std::uint32_t> recent_items_;

  std::vector<std::string> problems_;
  bool has_given_up_ = false, was_alive_ = true, jumped_ = false;
  // Fires when the view is this close to the target; 0: does not fire.
  float fire_tolerance_deg_ = 0;
  int pending_impulse_ = 0;
  std::vector<std::string> deaths_;
  std::uint64_t tick_ = 0;
};

}  // namespace temblor::player
