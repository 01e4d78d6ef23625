#include "scripted_player/navigation/planner.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::player {
namespace {

namespace field = server::field;

// How far from a player's box an entity may be so that the player can still press it, pick it up, or kill it.
constexpr float kPressReach_units = 14, kItemReach_units = 6;
constexpr std::array<float, 3> kKillReaches_units = {48, 160, 400};
// A shot may hit this far beside a target, because its box is not its exact shape.
constexpr float kShootReach_units = 900, kAimSlack_units = 6;
// Added to a task's cost for each time that its entity was used before, so that the planner prefers others.
constexpr float kUseCost = 2500;
// Places this near to a failed attempt are tried last.
constexpr float kFailed_units = 36;
constexpr int kMaxDetours = 4, kMaxRelays = 6, kMaxUses = 6;
constexpr math::Vec3 kEyeOffset{0, 0, 22};

}  // namespace

int Planner::uses(vm::EntityIndex entity) const {
  const auto found = uses_.find(static_cast<std::uint32_t>(entity));
  return found == uses_.end() ? 0 : found->second;
}

Task Planner::make_exit_task(const Trigger& exit) const {
  return {.kind = TaskKind::kReach,
          .entity = exit.entity,
          .box = exit.box,
          .description = fmt::format("the exit to {}", exit.map),
          .goals = graph_->find_touching(exit.box, 0)};
}

Task Planner::make_task(TaskKind kind, vm::EntityIndex entity) {
  const server::Edict edict = game_->world().edicts.at(entity);
  Task task{.kind = kind, .entity = entity, .box = entity_box(edict)};
  task.description = describe(*game_, entity);
  switch (kind) {
    case TaskKind::kReach:
    case TaskKind::kTouch:
    case TaskKind::kVisit:
      task.goals = graph_->find_touching(task.box, 0);
      break;
    case TaskKind::kPress:
      task.goals = graph_->find_touching(task.box, kPressReach_units);
      break;
    case TaskKind::kTake:
      task.goals = graph_->find_touching(task.box, kItemReach_units);
      break;
    case TaskKind::kKill:
      // A monster may stand where no player can, so take the nearest places from which it may be fought.
      for (const float reach : kKillReaches_units)
        if (task.goals.empty()) task.goals = graph_->find_touching(task.box, reach);
      break;
    case TaskKind::kShoot: {
      // Finding these takes a trace from every place in range, so keep them; only the weapon's range changes.
      auto& places = shooting_places_[static_cast<std::uint32_t>(entity)];
      if (places.empty()) places = find_shooting_places(task.box);
      for (const std::uint32_t place : places) {
        const math::Vec3 eye = graph_->place(place).at + kEyeOffset;
        if (glm::distance(eye, glm::clamp(eye, task.box.mins, task.box.maxs)) < shot_reach_units_)
          task.goals.push_back(place);
      }
      break;
    }
  }
  skip_failed_places(task);
  return task;
}

void Planner::record_failure(vm::EntityIndex entity, const math::Vec3& from) {
  record_use(entity);
  failed_from_[static_cast<std::uint32_t>(entity)].push_back(from);
}

// Removes goals near failed attempts, unless that would leave none.
void Planner::skip_failed_places(Task& io_task) const {
  const auto failed = failed_from_.find(static_cast<std::uint32_t>(io_task.entity));
  if (failed == failed_from_.end()) return;
  std::vector<std::uint32_t> left;
  for (const std::uint32_t goal : io_task.goals)
    if (std::none_of(failed->second.begin(), failed->second.end(), [&](const math::Vec3& from) {
          return glm::distance(from, graph_->place(goal).at) < kFailed_units;
        }))
      left.push_back(goal);
  if (!left.empty()) io_task.goals = std::move(left);
}

// The trace through the world ends at the target's own box if the target is recessed, so compare where it
// ends.
std::vector<std::uint32_t> Planner::find_shooting_places(const math::Bounds& box) const {
  std::vector<std::uint32_t> found;
  const math::Vec3 aim = box_center(box);
  for (std::uint32_t i = 0; i < graph_->places().size(); ++i) {
    const math::Vec3 eye = graph_->place(i).at + kEyeOffset;
    if (glm::distance(eye, aim) > kShootReach_units) continue;
    const world::Trace trace =
        world::trace_line(space_->level(), world::ModelIndex{0}, world::Hull::kPoint, eye, aim);
    if (boxes_overlap({trace.end - kAimSlack_units, trace.end + kAimSlack_units}, box) &&
        space_->is_line_free_of_movers(eye, aim, box))
      found.push_back(i);
  }
  return found;
}

std::optional<Task> Planner::plan(std::uint32_t from, Task goal) {
  problems_.clear();
  router_->survey(from);
  std::vector<int> visited;
  return plan_inner(from, std::move(goal), visited);
}

// Steps: 1. a route without locked movers; 2. a route through the fewest locked movers, then plan for the
// first of them;
// 3. if that fails, ban that mover and repeat 2.
std::optional<Task> Planner::plan_inner(std::uint32_t from, Task goal, std::vector<int>& io_visited) {
  if (goal.goals.empty()) {
    problems_.push_back(fmt::format("{}: no reachable place touches it", goal.description));
    return std::nullopt;
  }
  if (std::optional<Route> route = router_->find_surveyed(goal.goals)) {
    goal.route = std::move(*route);
    return goal;
  }
  RouteRules rules{.passes_locked = true, .banned_movers = io_visited};
  for (int detour = 0; detour < kMaxDetours; ++detour) {
    const std::optional<Route> route = router_->find(from, goal.goals, rules);
    if (!route || route->locked_mover < 0) {
      report_dead_end(goal, detour > 0);
      return std::nullopt;
    }
    const int mover = route->locked_mover;
    io_visited.push_back(mover);
    std::optional<Task> task = choose_way_to_open(from, mover, io_visited);
    io_visited.pop_back();
    if (task) return task;
    const Mover& m = space_->facts().movers[static_cast<std::size_t>(mover)];
    problems_.push_back(fmt::format("{}: blocked by {}", goal.description, m.description));
    rules.banned_movers.push_back(mover);
  }
  return std::nullopt;
}

// Adds a message with the nearest position that can be reached. After a detour, the messages about its movers
// say enough.
void Planner::report_dead_end(const Task& goal, bool is_detour) {
  if (is_detour) return;
  const std::optional<math::Vec3> near = router_->find_nearest_reached(goal.box);
  const math::Vec3 at = near.value_or(math::Vec3(0.0f));
  problems_.push_back(fmt::format(
      "{}: no route, even with all doors open; the nearest reachable place is {:.0f} {:.0f} {:.0f}",
      goal.description, at.x, at.y, at.z));
}

// Plans each way to open the mover and returns the cheapest.
std::optional<Task> Planner::choose_way_to_open(std::uint32_t from, int mover, std::vector<int>& io_visited) {
  std::optional<Task> best;
  float best_cost = 0;
  std::vector<int> doors = {mover};
  for (Task& candidate : list_ways_to_open(mover, doors)) {
    const int used = uses(candidate.entity);
    if (used >= kMaxUses) continue;
    if (candidate.opens < 0) candidate.opens = mover;
    std::optional<Task> task = plan_inner(from, std::move(candidate), io_visited);
    if (!task) continue;
    const float cost = task->route.cost + kUseCost * static_cast<float>(used);
    if (best && best_cost <= cost) continue;
    best = std::move(task);
    best_cost = cost;
  }
  return best;
}

// Returns tasks without routes: touch it with the key, fetch the key, shoot it, or activate what targets it.
std::vector<Task> Planner::list_ways_to_open(int mover, std::vector<int>& io_doors) {
  const Mover& m = space_->facts().movers[static_cast<std::size_t>(mover)];
  std::vector<Task> tasks;
  if (m.key != 0 && (items_ & m.key) != 0) {
    // The player has the key, so a touch opens it.
    for (const MoverPart& part : m.parts) tasks.push_back(make_task(TaskKind::kPress, part.entity));
    return tasks;
  }
  if (m.key != 0) {
    const char* key = m.key == kSilverKey ? "item_key1" : "item_key2";
    server::GameWorld& world = game_->world();
    for (std::uint32_t i = 1; i < world.edicts.count(); ++i) {
      const vm::EntityIndex entity{i};
      if (world.edicts.is_free(entity) || class_name(*game_, entity) != key ||
          world.edicts[entity].solid() != server::Solid::kTrigger)
        continue;
      tasks.push_back(make_task(TaskKind::kTake, entity));
      tasks.back().opens = mover;
    }
    if (tasks.empty())
      problems_.push_back(
          fmt::format("{}: needs a key, but there is no {} in the level", m.description, key));
    return tasks;
  }
  if (m.is_shot)
    for (const MoverPart& part : m.parts) tasks.push_back(make_task(TaskKind::kShoot, part.entity));
  if (!m.target_name.empty()) {
    add_activators(m.target_name, 0, tasks, io_doors);
    if (tasks.empty())
      problems_.push_back(fmt::format("{}: no usable button, trigger, item, or monster targets \"{}\"",
                                      m.description, m.target_name));
  }
  return tasks;
}

// Returns whether the activator can still fire: buttons and triggers that fire only once become unusable.
bool Planner::is_usable(const Activator& activator) const {
  server::GameWorld& world = game_->world();
  if (!server::is_there(world, activator.entity)) return false;
  const server::Edict edict = world.edicts[activator.entity];
  switch (activator.kind) {
    case ActivatorKind::kPress:
    case ActivatorKind::kShoot:
      return edict.solid() != server::Solid::kNot;
    case ActivatorKind::kTouch:
      return edict.solid() == server::Solid::kTrigger &&
             game_->machine().program().function_name(edict[field::kTouch]) != "nothing";
    case ActivatorKind::kTake:
      return edict.solid() == server::Solid::kTrigger;
    case ActivatorKind::kKill:
      return edict[field::kHealth] > 0;
    case ActivatorKind::kOpen:
      return true;
  }
  return false;
}

void Planner::add_activators(const std::string& name, int depth, std::vector<Task>& io_tasks,
                             std::vector<int>& io_doors) {
  if (depth > kMaxRelays || name.empty()) return;
  const LevelFacts& facts = space_->facts();
  for (const Activator& activator : facts.activators) {
    if ((activator.target != name && activator.kill_target != name) || !is_usable(activator)) continue;
    static constexpr std::array<TaskKind, 5> kKinds = {TaskKind::kPress, TaskKind::kShoot, TaskKind::kTouch,
                                                       TaskKind::kTake, TaskKind::kKill};
    if (activator.kind != ActivatorKind::kOpen) {
      io_tasks.push_back(make_task(kKinds[static_cast<std::size_t>(activator.kind)], activator.entity));
      io_tasks.back().look = activator.look;
      continue;
    }
    // This door fires its targets when it opens, so opening it is a way.
    const int door = facts.find_mover(activator.entity);
    if (door < 0 || std::find(io_doors.begin(), io_doors.end(), door) != io_doors.end()) continue;
    io_doors.push_back(door);
    if (facts.movers[static_cast<std::size_t>(door)].opens_automatically) {
      io_tasks.push_back(make_task(TaskKind::kPress, activator.entity));
      continue;
    }
    for (Task& task : list_ways_to_open(door, io_doors)) io_tasks.push_back(std::move(task));
  }
  for (const Relay& relay : facts.relays)
    if (relay.target == name || relay.kill_target == name)
      add_activators(relay.target_name, depth + 1, io_tasks, io_doors);
}

}  // namespace temblor::player
