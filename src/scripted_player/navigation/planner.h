// What has to be done first so that a goal can be reached: doors opened, keys fetched, buttons pressed.
//
// Method: a way is searched as if locked doors were open, at a price. What opens the first locked one on it
// is the next goal, by the same method, until there is one that can be reached as things are.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scripted_player/navigation/router.h"
#include "server/game.h"

namespace temblor::player {

enum class TaskKind { kReach, kPress, kShoot, kTouch, kTake, kKill, kVisit };

struct Task {
  TaskKind kind = TaskKind::kReach;
  vm::EntityIndex entity{};
  math::Bounds box{};
  math::Vec3 look{0.0f};  // has to be looked at there; 0: anywhere
  int opens = -1;         // the mover that this is to open
  int stop = 0;           // of a tour, for which that is; 0: none
  double stay_s = 0;      // visits: so long
  int impulse = 0;        // visits: fires with that weapon meanwhile; 0: does not
  std::string describe{};
  std::vector<std::uint32_t> goals{};
  Route route{};
};

class Planner {
 public:
  Planner(server::Game& io_game, const NavSpace& space, const NavGraph& graph, Router& io_router)
      : game_(&io_game), space_(&space), graph_(&graph), router_(&io_router) {}

  // What the player carries: keys.
  void set_items(int items) { items_ = items; }
  // How far the shot goes that he would spend on a target.
  void set_shot_reach(float reach_units) { shot_reach_units_ = reach_units; }

  // The next thing to do from there; nothing: it cannot be reached, see why_not().
  std::optional<Task> plan(std::uint32_t from, Task goal);
  const std::vector<std::string>& why_not() const { return why_not_; }

  Task task_for_exit(const Trigger& exit) const;
  Task task_for(TaskKind kind, vm::EntityIndex entity);
  // It was done, or tried in vain.
  void note_use(vm::EntityIndex entity) { ++uses_[static_cast<std::uint32_t>(entity)]; }
  // In vain, from there: other places are tried first.
  void note_vain(vm::EntityIndex entity, const math::Vec3& from);
  int uses(vm::EntityIndex entity) const;

 private:
  std::optional<Task> plan_inner(std::uint32_t from, Task goal, std::vector<int>& io_visited);
  void leave_out_vain(Task& io_task) const;
  void note_dead_end(const Task& goal, bool is_detour);
  // `io_doors`: those that are being looked at; they may fire one another in a circle.
  std::vector<Task> ways_to_open(int mover, std::vector<int>& io_doors);
  void add_firing(const std::string& name, int depth, std::vector<Task>& io_tasks,
                  std::vector<int>& io_doors);
  bool is_usable(const Activator& activator) const;
  std::vector<std::uint32_t> places_to_shoot(const math::Bounds& box) const;
  std::optional<Task> best_way_to_open(std::uint32_t from, int mover, std::vector<int>& io_visited);

  server::Game* game_;
  const NavSpace* space_;
  const NavGraph* graph_;
  Router* router_;
  int items_ = 0;
  float shot_reach_units_ = 900;
  std::map<std::uint32_t, int> uses_;
  std::map<std::uint32_t, std::vector<math::Vec3>> vain_;
  std::map<std::uint32_t, std::vector<std::uint32_t>> shooting_places_;
  std::vector<std::string> why_not_;
};

}  // namespace temblor::player
