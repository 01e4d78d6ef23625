// What a player does next.
#include <fmt/format.h>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/decisions/pick.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kFromPlace_units = 64;
constexpr double kForgiveAfter_s = 6, kDeadEndAfter_s = 10;
constexpr int kSecretTries = 3;

}  // namespace

void Brain::give_up_task(const Self& self) {
  planner_.note_vain(task_->entity, self.origin);
  planned_.reset();
}

std::vector<bool> Brain::premises(int items) const {
  std::vector<bool> premises;
  for (std::size_t i = 0; i < map_->facts.movers.size(); ++i)
    for (int state = 0; state < map_->facts.movers[i].states; ++state)
      premises.push_back(movers_.access(static_cast<int>(i), state) >= Access::kLocked);
  for (const int key : {kSilverKey, kGoldKey}) premises.push_back((items & key) != 0);
  return premises;
}

std::optional<Task> Brain::task_to_take(server::Game& io_game, const Pick& pick, std::uint32_t at) {
  Task task{.kind = TaskKind::kTake,
            .entity = pick.entity,
            .box = box_of(io_game.world().edicts[pick.entity]),
            .describe = player::describe(io_game, pick.entity),
            .goals = {pick.place}};
  std::optional<Route> route = router_.find(at, task.goals);
  if (!route) return std::nullopt;
  task.route = std::move(*route);
  return task;
}

std::optional<Task> Brain::interrupted_task(std::uint32_t at) {
  std::optional<Route> route = router_.find(at, planned_->goals);
  if (!route) return std::nullopt;
  Task task = *planned_;
  task.route = std::move(*route);
  return task;
}

int Brain::nearest_place(const Self& self) const {
  const int at = map_->graph.nearest(self.origin, kFromPlace_units, [&](const Place& place) {
    return place.mover < 0 || movers_.state(place.mover) == place.state;
  });
  return at >= 0 ? at : map_->graph.nearest(self.origin, kFromPlace_units);
}

void Brain::find_work(const Self& self, double now_s) {
  planned_s_ = now_s;
  is_side_task_ = false;
  const int at = nearest_place(self);
  std::optional<Task> task;
  const std::vector<bool> premises = this->premises(self.items);
  if (planned_ && at >= 0 && premises == planned_on_) task = interrupted_task(static_cast<std::uint32_t>(at));
  if (!task && at >= 0) {
    task = next_task(static_cast<std::uint32_t>(at));
    planned_ = task;
    planned_on_ = premises;
  }
  if (task) {
    in_vain_since_s_.reset();
    take_up(std::move(*task), now_s);
    return;
  }
  if (!in_vain_since_s_) in_vain_since_s_ = now_s;
  if (now_s - *in_vain_since_s_ > kForgiveAfter_s) router_.forgive();
  if (now_s - *in_vain_since_s_ > kDeadEndAfter_s && dead_ends_ < kMaxDeadEnds) {
    in_vain_since_s_ = now_s;
    begin_again_from(self);
  }
  if (now_s - *in_vain_since_s_ > setup_.patience_s && !has_given_up_) {
    has_given_up_ = true;
    const math::Vec3 o = self.origin;
    if (at < 0)
      complain(fmt::format("stands at {:.0f} {:.0f} {:.0f}, where nobody should get", o.x, o.y, o.z));
    complain(fmt::format("gave up at {:.0f} {:.0f} {:.0f}", o.x, o.y, o.z));
    for (const std::string& reason : planner_.why_not()) complain(reason);
  }
}

std::optional<Task> Brain::next_task(std::uint32_t at) {
  if (auto task = task_for_waypoint(at)) return task;
  if (setup_.roams) return task_for_roaming(at);
  if (setup_.visits_stops)
    if (auto task = task_for_stop(at)) return task;
  if (setup_.visits_secrets) {
    if (auto task = task_for_secret(at)) return task;
    if (waits_for_secret_) return std::nullopt;
  }
  return task_for_exit(at);
}

std::optional<Task> Brain::task_for_waypoint(std::uint32_t at) {
  while (waypoint_ < setup_.waypoints.size()) {
    const math::Vec3& to = setup_.waypoints[waypoint_];
    const int goal = map_->graph.nearest(to, 96);
    Task task{.kind = TaskKind::kTouch, .describe = fmt::format("waypoint {}", waypoint_ + 1)};
    if (goal >= 0) task.goals = {static_cast<std::uint32_t>(goal)};
    const bool is_there = goal >= 0 && glm::distance(map_->graph.place(at).at, to) < 72;
    std::optional<Task> planned = is_there ? std::nullopt : planner_.plan(at, std::move(task));
    if (planned) return planned;
    if (!is_there)
      complain(fmt::format("waypoint {} at {:.0f} {:.0f} {:.0f} cannot be reached", waypoint_ + 1, to.x, to.y,
                           to.z));
    ++waypoint_;
  }
  return std::nullopt;
}

std::optional<Task> Brain::task_for_secret(std::uint32_t at) {
  std::optional<Task> best;
  waits_for_secret_ = false;
  for (const vm::EntityIndex secret : map_->facts.secrets) {
    const auto number = static_cast<std::uint32_t>(secret);
    if (hopeless_secrets_.contains(number) || !server::is_there(game_->world(), secret) ||
        class_name(*game_, secret) != "trigger_secret")
      continue;
    const server::Edict edict = game_->world().edicts[secret];
    if (edict.solid() != server::Solid::kTrigger ||
        game_->machine().program().name_of(edict[field::kTouch]) == "nothing")
      continue;
    std::optional<Task> task = planner_.plan(at, planner_.task_for(TaskKind::kTouch, secret));
    // Something on the way may be moving just now.
    if (!task && ++vain_secrets_[number] < kSecretTries) {
      waits_for_secret_ = true;
      continue;
    }
    if (!task || planner_.uses(secret) > kSecretTries) {
      hopeless_secrets_.insert(number);
      complain(fmt::format("secret not reached: {}", player::describe(*game_, secret)));
      for (const std::string& reason : planner_.why_not()) complain("  " + reason);
      continue;
    }
    if (!best || task->route.cost < best->route.cost) best = std::move(task);
  }
  return best;
}

std::optional<Task> Brain::task_for_exit(std::uint32_t at) {
  std::optional<Task> best;
  bool has_exit = false;
  for (const Trigger& trigger : map_->facts.triggers) {
    if (trigger.kind != TriggerKind::kExit) continue;
    if (!setup_.exit_map.empty() && trigger.map != setup_.exit_map) continue;
    has_exit = true;
    std::optional<Task> task = planner_.plan(at, planner_.task_for_exit(trigger));
    if (task && (!best || task->route.cost < best->route.cost)) best = std::move(task);
  }
  if (!has_exit)
    complain(setup_.exit_map.empty() ? "the level has no trigger_changelevel"
                                     : fmt::format("no trigger_changelevel leads to {}", setup_.exit_map));
  return best;
}

}  // namespace temblor::player
