// A player: from what he knows and sees to one move a tick.
#pragma once

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "net/protocol/client_message.h"
#include "scripted_player/decisions/fighter.h"
#include "scripted_player/decisions/walker.h"
#include "scripted_player/navigation/level_map.h"
#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/planner.h"
#include "scripted_player/navigation/router.h"
#include "scripted_player/view.h"

namespace temblor::player {

struct Pick;

struct BrainSetup {
  std::uint64_t seed = 1;
  std::size_t slot = 0;
  bool visits_secrets = false;
  bool fights = true;
  bool fights_players = false;          // a deathmatch
  bool visits_stops = false;            // of the level, before anything else but waypoints
  bool roams = false;                   // from item to item, for ever; no exit
  std::vector<math::Vec3> waypoints{};  // visited in order before anything else
  std::string exit_map{};               // of several exits the one that leads there
  double patience_s = 20;               // that a goal may be out of reach
};

class Brain {
 public:
  // `map` must outlive it.
  Brain(const LevelMap& map, server::Game& io_game, const BrainSetup& setup);

  // The level began anew: the same entities in another game.
  void begin_again(server::Game& io_game);
  // `view_deg`: where the server has turned him, if it did.
  net::Move think(server::Game& io_game, std::optional<math::Vec3> view_deg, double now_s);

  // Stands where no way leads on, and wants to begin the level again ("kill"). Asked once.
  bool wants_to_begin_again() { return std::exchange(wants_to_begin_again_, false); }
  bool has_given_up() const { return has_given_up_; }
  // Why, a line each; also secrets that cannot be reached.
  const std::vector<std::string>& complaints() const { return complaints_; }
  // What he is about, for messages.
  std::string describe() const;
  // A line each: where, and of what.
  const std::vector<std::string>& deaths() const { return deaths_; }
  // Whether that mover was open at any time since the level began.
  bool saw_open(int mover) const { return movers_.was_opened(mover); }

 private:
  enum class Phase { kWalk, kAct };

  std::optional<Task> next_task(std::uint32_t at);
  std::optional<Task> interrupted_task(std::uint32_t at);
  // What a plan rests upon: which movers are locked, and the keys.
  std::vector<bool> premises(int items) const;
  std::optional<Task> task_for_waypoint(std::uint32_t at);
  std::optional<Task> task_for_stop(std::uint32_t at);
  std::optional<Task> task_for_button(std::uint32_t at, const Stop& stop);
  void note_visited();
  void visit(const Self& self, double now_s, Steering& out);
  std::optional<Task> task_for_roaming(std::uint32_t at);
  std::optional<Task> task_for_secret(std::uint32_t at);
  std::optional<Task> task_for_exit(std::uint32_t at);
  std::optional<Task> task_for_item(server::Game& io_game, const Self& self, std::uint32_t at);
  std::optional<Task> task_to_take(server::Game& io_game, const Pick& pick, std::uint32_t at);
  void take_up(Task task, double now_s);
  void drop_task() {
    task_.reset();
    walker_.stop();
  }
  bool is_done(server::Game& io_game, const Self& self) const;
  bool route_has_shut() const;
  void work(server::Game& io_game, const Self& self, double now_s, Steering& out);
  void act(server::Game& io_game, const Self& self, double now_s, Steering& out);
  int nearest_place(const Self& self) const;
  bool fights_first(double now_s);
  void give_up_task(const Self& self);
  void find_work(const Self& self, double now_s);
  void find_back(server::Game& io_game, const Self& self, double now_s, Steering& out);
  math::Vec3 heading_off(server::Game& io_game, const Self& self);
  void begin_again_from(const Self& self);
  net::Move move_for(const Self& self, const Steering& steering);
  void note_death(server::Game& io_game, const Self& self);
  void complain(const std::string& text);

  const LevelMap* map_;
  server::Game* game_;
  BrainSetup setup_;
  Dice dice_;
  MoverWatch movers_;
  Router router_;
  Planner planner_;
  Walker walker_;
  Fighter fighter_;
  View view_;
  std::optional<Task> task_;
  std::optional<Task> planned_;  // taken up again after a detour
  std::vector<bool> planned_on_;
  bool is_side_task_ = false;
  Phase phase_ = Phase::kWalk;
  double phase_since_s_ = 0, looked_for_items_s_ = 0, planned_s_ = -10, checked_route_s_ = 0;
  std::optional<double> in_vain_since_s_;
  double settled_since_s_ = 0, fights_first_until_s_ = -100;
  std::set<std::uint32_t> hopeless_secrets_;
  std::map<std::uint32_t, int> vain_secrets_;  // how often there was no way to one
  bool waits_for_secret_ = false, wants_to_begin_again_ = false;
  static constexpr int kMaxDeadEnds = 3;
  int dead_ends_ = 0;
  std::optional<double> astray_since_s_;  // off all places that are known
  math::Vec3 heading_{0.0f};
  double heading_until_s_ = 0;
  std::map<std::uint32_t, int> tried_items_;
  std::size_t waypoint_ = 0, stop_ = 0;
  bool has_pressed_ = false;              // what this stop asks for
  std::deque<std::uint32_t> was_lately_;  // items, on his rounds
  std::vector<std::string> complaints_;
  bool has_given_up_ = false, was_alive_ = true, jumped_ = false;
  float fire_tolerance_deg_ = 0;  // what he does wants a shot; 0: none
  int pending_impulse_ = 0;
  std::vector<std::string> deaths_;
  std::uint64_t tick_ = 0;
};

}  // namespace temblor::player
