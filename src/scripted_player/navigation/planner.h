// Decides what to do first so that a goal can be reached: open doors, fetch keys, press buttons.
//
// Method: backward chaining. If no route leads to the goal as things are, the planner searches a route as if
// locked movers were open, at a price. Whatever opens the first locked mover on it becomes the new goal, and
// so on, until a goal can be reached now:
//
//   exit <- behind door A <- opened by button B <- behind door C <- needs the silver key: reachable
//
// If a mover cannot be opened, the planner tries up to three detours around it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scripted_player/navigation/router.h"
#include "server/game.h"

namespace temblor::player {

enum class TaskKind { kReach, kPress, kShoot, kTouch, kTake, kKill, kVisit };

// One thing to do: follow the route, then act on the entity.
struct Task {
  TaskKind kind = TaskKind::kReach;
  vm::EntityIndex entity{};
  math::Bounds box{};
  // The direction that the player must face there; 0: any.
  math::Vec3 look{0.0f};
  // The mover that this opens; -1: none.
  int opens = -1;
  // The tour stop that this is for; 0: none.
  int stop = 0;
  // Only for kVisit: how long to stay, and the weapon to fire meanwhile (0: none).
  double stay_s = 0;
  int impulse = 0;
  // For messages: "func_button at 10 20 30".
  std::string description{};
  // Places from which it can be done.
  std::vector<std::uint32_t> goals{};
  Route route{};
};

class Planner {
 public:
  // All must outlive it.
  Planner(server::Game& io_game, const NavSpace& space, const NavGraph& graph, Router& io_router)
      : game_(&io_game), space_(&space), graph_(&graph), router_(&io_router) {}

  // Sets the bits of the player's items; keys matter.
  void set_items(int items) { items_ = items; }
  // Sets the range of the weapon that the player would use against a target.
  void set_shot_reach(float reach_units) { shot_reach_units_ = reach_units; }

  // Returns the first task on the way to the goal, with its route from that place; it is the goal itself if
  // nothing is in the way. Nothing: the goal cannot be reached, for the reasons in problems().
  std::optional<Task> plan(std::uint32_t from, Task goal);
  // Messages for level designers, from the last call of plan().
  const std::vector<std::string>& problems() const { return problems_; }

  Task make_exit_task(const Trigger& exit) const;
  // Fills in everything except the route.
  Task make_task(TaskKind kind, vm::EntityIndex entity);
  // Counts an attempt. An entity that was used before is avoided, and after six times ignored.
  void record_use(vm::EntityIndex entity) { ++uses_[static_cast<std::uint32_t>(entity)]; }
  // Like record_use(), and tries other places first from now on.
  void record_failure(vm::EntityIndex entity, const math::Vec3& from);
  int uses(vm::EntityIndex entity) const;

 private:
  // `io_visited`: movers that are being planned for, so that the recursion ends.
  std::optional<Task> plan_inner(std::uint32_t from, Task goal, std::vector<int>& io_visited);
  void skip_failed_places(Task& io_task) const;
  void report_dead_end(const Task& goal, bool is_detour);
  // `io_doors`: doors that are being examined; they may fire one another in a circle.
  std::vector<Task> list_ways_to_open(int mover, std::vector<int>& io_doors);
  // Adds the tasks that fire an entity with this targetname, directly or through relays.
  void add_activators(const std::string& name, int depth, std::vector<Task>& io_tasks,
                      std::vector<int>& io_doors);
  bool is_usable(const Activator& activator) const;
  std::vector<std::uint32_t> find_shooting_places(const math::Bounds& box) const;
  std::optional<Task> choose_way_to_open(std::uint32_t from, int mover, std::vector<int>& io_visited);

  server::Game* game_;
  const NavSpace* space_;
  const NavGraph* graph_;
  Router* router_;
  int items_ = 0;
  float shot_reach_units_ = 900;
  // By entity: attempts, positions of failed attempts, and places from which a shot can hit it.
  std::map<std::uint32_t, int> uses_;
  std::map<std::uint32_t, std::vector<math::Vec3>> failed_from_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> shooting_places_;
  std::vector<std::string> problems_;
};

}  // namespace temblor::player
