#include "scripted_player/navigation/planner.h"

#include <fmt/format.h>

#include <algorithm>

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kPressReach_units = 14, kItemReach_units = 6;
constexpr std::array<float, 3> kKillReaches_units = {48, 160, 400};
constexpr float kShootReach_units = 900, kAimSlack_units = 6;
constexpr float kUseCost = 2500;
constexpr float kVain_units = 36;
constexpr int kMaxDetours = 4, kMaxRelays = 6, kMaxUses = 6;
constexpr math::Vec3 kEyes{0, 0, 22};

}  // namespace

int Planner::uses(vm::EntityIndex entity) const {
  const auto found = uses_.find(static_cast<std::uint32_t>(entity));
  return found == uses_.end() ? 0 : found->second;
}

Task Planner::task_for_exit(const Trigger& exit) const {
  return {.kind = TaskKind::kReach,
          .entity = exit.entity,
          .box = exit.box,
          .describe = fmt::format("the exit to {}", exit.map),
          .goals = graph_->touching(exit.box, 0)};
}

Task Planner::task_for(TaskKind kind, vm::EntityIndex entity) {
  const server::Edict edict = game_->world().edicts.at(entity);
  Task task{.kind = kind, .entity = entity, .box = box_of(edict)};
  task.describe = describe(*game_, entity);
  switch (kind) {
    case TaskKind::kReach:
    case TaskKind::kTouch:
    case TaskKind::kVisit:
      task.goals = graph_->touching(task.box, 0);
      break;
    case TaskKind::kPress:
      task.goals = graph_->touching(task.box, kPressReach_units);
      break;
    case TaskKind::kTake:
      task.goals = graph_->touching(task.box, kItemReach_units);
      break;
    case TaskKind::kKill:
      // It may stand where no player can.
      for (const float reach : kKillReaches_units)
        if (task.goals.empty()) task.goals = graph_->touching(task.box, reach);
      break;
    case TaskKind::kShoot: {
      auto& places = shooting_places_[static_cast<std::uint32_t>(entity)];
      if (places.empty()) places = places_to_shoot(task.box);
      for (const std::uint32_t place : places) {
        const math::Vec3 eye = graph_->place(place).at + kEyes;
        if (glm::distance(eye, glm::clamp(eye, task.box.mins, task.box.maxs)) < shot_reach_units_)
          task.goals.push_back(place);
      }
      break;
    }
  }
  leave_out_vain(task);
  return task;
}

void Planner::note_vain(vm::EntityIndex entity, const math::Vec3& from) {
  note_use(entity);
  vain_[static_cast<std::uint32_t>(entity)].push_back(from);
}

void Planner::leave_out_vain(Task& io_task) const {
  const auto vain = vain_.find(static_cast<std::uint32_t>(io_task.entity));
  if (vain == vain_.end()) return;
  std::vector<std::uint32_t> left;
  for (const std::uint32_t goal : io_task.goals)
    if (std::none_of(vain->second.begin(), vain->second.end(), [&](const math::Vec3& from) {
          return glm::distance(from, graph_->place(goal).at) < kVain_units;
        }))
      left.push_back(goal);
  if (!left.empty()) io_task.goals = std::move(left);
}

std::vector<std::uint32_t> Planner::places_to_shoot(const math::Bounds& box) const {
  std::vector<std::uint32_t> found;
  const math::Vec3 aim = middle_of(box);
  for (std::uint32_t i = 0; i < graph_->places().size(); ++i) {
    const math::Vec3 eye = graph_->place(i).at + kEyes;
    if (glm::distance(eye, aim) > kShootReach_units) continue;
    const world::Trace trace =
        world::trace_line(space_->level(), world::ModelIndex{0}, world::Hull::kPoint, eye, aim);
    if (boxes_meet({trace.end - kAimSlack_units, trace.end + kAimSlack_units}, box) &&
        space_->is_line_free_of_movers(eye, aim, box))
      found.push_back(i);
  }
  return found;
}

std::optional<Task> Planner::plan(std::uint32_t from, Task goal) {
  why_not_.clear();
  router_->survey(from);
  std::vector<int> visited;
  return plan_inner(from, std::move(goal), visited);
}

std::optional<Task> Planner::plan_inner(std::uint32_t from, Task goal, std::vector<int>& io_visited) {
  if (goal.goals.empty()) {
    why_not_.push_back(fmt::format("{}: no place from which a player can start leads there", goal.describe));
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
      note_dead_end(goal, detour > 0);
      return std::nullopt;
    }
    const int mover = route->locked_mover;
    io_visited.push_back(mover);
    std::optional<Task> task = best_way_to_open(from, mover, io_visited);
    io_visited.pop_back();
    if (task) return task;
    const Mover& m = space_->facts().movers[static_cast<std::size_t>(mover)];
    why_not_.push_back(fmt::format("{}: the way there is shut by {}", goal.describe, m.describe));
    rules.banned_movers.push_back(mover);
  }
  return std::nullopt;
}

void Planner::note_dead_end(const Task& goal, bool is_detour) {
  if (is_detour) return;
  const std::optional<math::Vec3> near = router_->nearest_reached(goal.box);
  const math::Vec3 at = near.value_or(math::Vec3(0.0f));
  why_not_.push_back(
      fmt::format("{}: no way leads there, even with everything open; the nearest that one gets is {:.0f} "
                  "{:.0f} {:.0f}",
                  goal.describe, at.x, at.y, at.z));
}

std::optional<Task> Planner::best_way_to_open(std::uint32_t from, int mover, std::vector<int>& io_visited) {
  std::optional<Task> best;
  float best_cost = 0;
  std::vector<int> doors = {mover};
  for (Task& candidate : ways_to_open(mover, doors)) {
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

std::vector<Task> Planner::ways_to_open(int mover, std::vector<int>& io_doors) {
  const Mover& m = space_->facts().movers[static_cast<std::size_t>(mover)];
  std::vector<Task> tasks;
  if (m.key != 0 && (items_ & m.key) != 0) {
    // Nothing but a touch of it is missing.
    for (const MoverPart& part : m.parts) tasks.push_back(task_for(TaskKind::kPress, part.entity));
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
      tasks.push_back(task_for(TaskKind::kTake, entity));
      tasks.back().opens = mover;
    }
    if (tasks.empty()) why_not_.push_back(fmt::format("{}: the level has no {} left", m.describe, key));
    return tasks;
  }
  if (m.is_shot)
    for (const MoverPart& part : m.parts) tasks.push_back(task_for(TaskKind::kShoot, part.entity));
  if (!m.target_name.empty()) {
    add_firing(m.target_name, 0, tasks, io_doors);
    if (tasks.empty())
      why_not_.push_back(fmt::format("{}: nothing is left that fires \"{}\"", m.describe, m.target_name));
  }
  return tasks;
}

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
             game_->machine().program().name_of(edict[field::kTouch]) != "nothing";
    case ActivatorKind::kTake:
      return edict.solid() == server::Solid::kTrigger;
    case ActivatorKind::kKill:
      return edict[field::kHealth] > 0;
    case ActivatorKind::kOpen:
      return true;
  }
  return false;
}

void Planner::add_firing(const std::string& name, int depth, std::vector<Task>& io_tasks,
                         std::vector<int>& io_doors) {
  if (depth > kMaxRelays || name.empty()) return;
  const LevelFacts& facts = space_->facts();
  for (const Activator& activator : facts.activators) {
    if ((activator.target != name && activator.kill_target != name) || !is_usable(activator)) continue;
    static constexpr std::array<TaskKind, 5> kKinds = {TaskKind::kPress, TaskKind::kShoot, TaskKind::kTouch,
                                                       TaskKind::kTake, TaskKind::kKill};
    if (activator.kind != ActivatorKind::kOpen) {
      io_tasks.push_back(task_for(kKinds[static_cast<std::size_t>(activator.kind)], activator.entity));
      io_tasks.back().look = activator.look;
      continue;
    }
    // What opens that door, fires this.
    const int door = facts.mover_of(activator.entity);
    if (door < 0 || std::find(io_doors.begin(), io_doors.end(), door) != io_doors.end()) continue;
    io_doors.push_back(door);
    if (facts.movers[static_cast<std::size_t>(door)].opens_by_itself) {
      io_tasks.push_back(task_for(TaskKind::kPress, activator.entity));
      continue;
    }
    for (Task& task : ways_to_open(door, io_doors)) io_tasks.push_back(std::move(task));
  }
  for (const Relay& relay : facts.relays)
    if (relay.target == name || relay.kill_target == name)
      add_firing(relay.target_name, depth + 1, io_tasks, io_doors);
}

}  // namespace temblor::player
