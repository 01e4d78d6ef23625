// The choice of the next task: waypoints, tour stops, secrets, and the exit, in this order; and giving up.
#include <fmt/format.h>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/decisions/choose_item.h"

namespace temblor::player {
namespace {

namespace field = server::field;

// The player is at a place if it is this near.
constexpr float kFromPlace_units = 64;
// Without a task for this long: forget the penalties of links, then restart the level.
constexpr double kForgiveAfter_s = 6, kDeadEndAfter_s = 10;
constexpr int kSecretTries = 3;

}  // namespace

void Brain::abandon_task(const Self& self) {
  planner_.record_failure(task_->entity, self.origin);
  planned_.reset();
}

std::vector<bool> Brain::list_premises(int items) const {
  std::vector<bool> premises;
  for (std::size_t i = 0; i < map_->facts.movers.size(); ++i)
    for (int state = 0; state < map_->facts.movers[i].states; ++state)
      premises.push_back(movers_.access(static_cast<int>(i), state) >= Access::kLocked);
  for (const int key : {kSilverKey, kGoldKey}) premises.push_back((items & key) != 0);
  return premises;
}

std::optional<Task> Brain::make_take_task(server::Game& io_game, const ItemChoice& item, std::uint32_t at) {
  Task task{.kind = TaskKind::kTake,
            .entity = item.entity,
            .box = entity_box(io_game.world().edicts[item.entity]),
            .description = player::describe(io_game, item.entity),
            .goals = {item.place}};
  std::optional<Route> route = router_.find(at, task.goals);
  if (!route) return std::nullopt;
  task.route = std::move(*route);
  return task;
}

// Searches only a new route for the planned task. Planning takes far longer, because it may search many
// routes.
std::optional<Task> Brain::resume_planned_task(std::uint32_t at) {
  std::optional<Route> route = router_.find(at, planned_->goals);
  if (!route) return std::nullopt;
  Task task = *planned_;
  task.route = std::move(*route);
  return task;
}

int Brain::nearest_place(const Self& self) const {
  const int at = map_->graph.find_nearest(self.origin, kFromPlace_units, [&](const Place& place) {
    return place.mover < 0 || movers_.state(place.mover) == place.state;
  });
  return at >= 0 ? at : map_->graph.find_nearest(self.origin, kFromPlace_units);
}

// If no task can be reached: waits, because a mover may be on its way; then forgets penalties; then restarts
// the level, at most kMaxDeadEnds times; then gives up.
void Brain::choose_task(const Self& self, double now_s) {
  planned_s_ = now_s;
  is_side_task_ = false;
  const int at = nearest_place(self);
  std::optional<Task> task;
  const std::vector<bool> premises = list_premises(self.items);
  if (planned_ && at >= 0 && premises == planned_on_)
    task = resume_planned_task(static_cast<std::uint32_t>(at));
  if (!task && at >= 0) {
    task = choose_next_task(static_cast<std::uint32_t>(at));
    planned_ = task;
    planned_on_ = premises;
  }
  if (task) {
    stalled_since_s_.reset();
    start_task(std::move(*task), now_s);
    return;
  }
  if (!stalled_since_s_) stalled_since_s_ = now_s;
  if (now_s - *stalled_since_s_ > kForgiveAfter_s) router_.clear_penalties();
  if (now_s - *stalled_since_s_ > kDeadEndAfter_s && dead_ends_ < kMaxDeadEnds) {
    stalled_since_s_ = now_s;
    request_restart(self);
  }
  if (now_s - *stalled_since_s_ > setup_.patience_s && !has_given_up_) {
    has_given_up_ = true;
    const math::Vec3 o = self.origin;
    if (at < 0)
      report_problem(fmt::format("is at {:.0f} {:.0f} {:.0f}, which no route should lead to", o.x, o.y, o.z));
    report_problem(fmt::format("gave up at {:.0f} {:.0f} {:.0f}", o.x, o.y, o.z));
    for (const std::string& reason : planner_.problems()) report_problem(reason);
  }
}

std::optional<Task> Brain::choose_next_task(std::uint32_t at) {
  if (auto task = plan_waypoint(at)) return task;
  if (setup_.roams) return plan_deathmatch_item(at);
  if (setup_.visits_stops)
    if (auto task = plan_stop(at)) return task;
  if (setup_.visits_secrets) {
    if (auto task = plan_secret(at)) return task;
    if (waits_for_secret_) return std::nullopt;
  }
  return plan_exit(at);
}

// Skips waypoints that are reached or cannot be reached.
std::optional<Task> Brain::plan_waypoint(std::uint32_t at) {
  while (waypoint_ < setup_.waypoints.size()) {
    const math::Vec3& to = setup_.waypoints[waypoint_];
    const int goal = map_->graph.find_nearest(to, 96);
    Task task{.kind = TaskKind::kTouch, .description = fmt::format("waypoint {}", waypoint_ + 1)};
    if (goal >= 0) task.goals = {static_cast<std::uint32_t>(goal)};
    const bool is_there = goal >= 0 && glm::distance(map_->graph.place(at).at, to) < 72;
    std::optional<Task> planned = is_there ? std::nullopt : planner_.plan(at, std::move(task));
    if (planned) return planned;
    if (!is_there)
      report_problem(fmt::format("waypoint {} at {:.0f} {:.0f} {:.0f} cannot be reached", waypoint_ + 1, to.x,
                                 to.y, to.z));
    ++waypoint_;
  }
  return std::nullopt;
}

// Returns the task with the cheapest first step toward a secret that is not found yet.
std::optional<Task> Brain::plan_secret(std::uint32_t at) {
  std::optional<Task> best;
  waits_for_secret_ = false;
  for (const vm::EntityIndex secret : map_->facts.secrets) {
    const auto number = static_cast<std::uint32_t>(secret);
    if (abandoned_secrets_.contains(number) || !server::is_there(game_->world(), secret) ||
        class_name(*game_, secret) != "trigger_secret")
      continue;
    const server::Edict edict = game_->world().edicts[secret];
    if (edict.solid() != server::Solid::kTrigger ||
        game_->machine().program().function_name(edict[field::kTouch]) == "nothing")
      continue;
    std::optional<Task> task = planner_.plan(at, planner_.make_task(TaskKind::kTouch, secret));
    // A mover on the route may be between two states, so try again before giving up.
    if (!task && ++secret_failures_[number] < kSecretTries) {
      waits_for_secret_ = true;
      continue;
    }
    if (!task || planner_.uses(secret) > kSecretTries) {
      abandoned_secrets_.insert(number);
      report_problem(fmt::format("secret not reached: {}", player::describe(*game_, secret)));
      for (const std::string& reason : planner_.problems()) report_problem("  " + reason);
      continue;
    }
    if (!best || task->route.cost < best->route.cost) best = std::move(task);
  }
  return best;
}

// Returns the task with the cheapest first step toward an exit.
std::optional<Task> Brain::plan_exit(std::uint32_t at) {
  std::optional<Task> best;
  bool has_exit = false;
  for (const Trigger& trigger : map_->facts.triggers) {
    if (trigger.kind != TriggerKind::kExit) continue;
    if (!setup_.exit_map.empty() && trigger.map != setup_.exit_map) continue;
    has_exit = true;
    std::optional<Task> task = planner_.plan(at, planner_.make_exit_task(trigger));
    if (task && (!best || task->route.cost < best->route.cost)) best = std::move(task);
  }
  if (!has_exit)
    report_problem(setup_.exit_map.empty()
                       ? "the level has no trigger_changelevel"
                       : fmt::format("no trigger_changelevel leads to {}", setup_.exit_map));
  return best;
}

}  // namespace temblor::player
