#include "game/player/brain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/angles.h"
#include "movement/player.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr double kPlanEvery_s = 2.5, kCheckRouteEvery_s = 0.4, kItemsEvery_s = 1.2;
constexpr double kSettle_s = 0.4;
constexpr double kForgiveAfter_s = 6, kDeadEndAfter_s = 10;
constexpr float kReachSlack_units = 4;
constexpr int kAttackButton = 1, kJumpButton = 2;
constexpr int kSecretTries = 3, kMostDeadEnds = 3;
constexpr float kFleeHealth = 45, kFleeCost = 600;

// Seconds that an act may take.
double time_for(TaskKind kind) {
  switch (kind) {
    case TaskKind::kReach:
      return 3;
    case TaskKind::kPress:
      return 1.5;
    case TaskKind::kShoot:
      return 4;
    case TaskKind::kTouch:
      return 1.5;
    case TaskKind::kTake:
      return 1.2;
    case TaskKind::kKill:
      return 4;
  }
  return 1;
}

}  // namespace

Brain::Brain(const LevelMap& map, server::Game& io_game, const BrainSetup& setup)
    : map_(&map),
      game_(&io_game),
      setup_(setup),
      dice_(setup.seed),
      movers_(map.facts),
      router_(map.graph, movers_),
      planner_(io_game, map.space, map.graph, router_),
      walker_(map.graph, map.space, movers_, router_, dice_),
      fighter_(dice_) {}

void Brain::begin_again(server::Game& io_game) {
  game_ = &io_game;
  movers_ = MoverWatch(map_->facts);
  router_.forgive();
  planner_ = Planner(io_game, map_->space, map_->graph, router_);
  fighter_ = Fighter(dice_);
  tried_items_.clear();
  in_vain_since_s_.reset();
  planned_.reset();
  waypoint_ = 0;
  drop_task();
}

std::string Brain::describe() const {
  if (!task_) return "knows of nothing to do";
  return fmt::format("on the way to {}: {}", task_->describe,
                     phase_ == Phase::kAct ? "is there, and does it" : walker_.describe());
}

void Brain::complain(const std::string& text) {
  if (std::find(complaints_.begin(), complaints_.end(), text) == complaints_.end())
    complaints_.push_back(text);
}

net::Move Brain::think(server::Game& io_game, std::optional<math::Vec3> view_deg, double now_s) {
  ++tick_;
  const Self self = feel_self(io_game, setup_.slot);
  if (view_deg) view_.set(*view_deg);
  if (!self.is_alive()) {
    const bool is_dead = io_game.player(setup_.slot)[field::kDeadFlag] != 0;
    if (was_alive_ && is_dead) note_death(io_game, self);
    was_alive_ = was_alive_ && !is_dead;
    drop_task();
    settled_since_s_ = now_s;
    // Buttons have to be let go of first.
    net::Move move{.angles_deg = view_.angles_deg()};
    move.buttons = tick_ % 40 == 0 ? kAttackButton : 0;
    return move;
  }
  if (!was_alive_) in_vain_since_s_.reset();
  was_alive_ = true;
  movers_.look(io_game, self.items);
  planner_.set_items(self.items);
  Steering steering;
  steering.look_at = self.eye() + math::Vec3(math::basis_from_angles(view_.angles_deg()).forward) * 100.0f;
  acts_fire_ = false;
  pending_impulse_ = 0;
  // First onto the floor.
  if (settled_since_s_ == 0) settled_since_s_ = now_s;
  if (now_s - settled_since_s_ > kSettle_s) work(io_game, self, now_s, steering);

  std::optional<FightPlan> fight;
  if (setup_.fights && !acts_fire_) fight = fighter_.fight(io_game, self, now_s);
  float haste = 1;
  math::Vec3 wanted = angles_towards(self.eye(), steering.look_at);
  if (glm::length(math::Vec2(steering.look_at - self.eye())) < 12) wanted = view_.angles_deg();
  if (!acts_fire_) wanted.x *= 0.6f;
  if (acts_fire_) haste = 1.6f;
  if (fight) {
    haste = 2.2f;
    wanted = angles_towards(self.eye(), fight->aim_at);
    // Badly wounded, with something in mind that helps, he fights on the way there.
    const bool flees = self.health < kFleeHealth && is_side_task_ && task_ && task_->route.cost < kFleeCost;
    if (steering.is_free && fight->stands_and_fights && !flees) {
      steering.velocity = fight->velocity;
      steering.jumps = false;
    }
    pending_impulse_ = fight->impulse;
  }
  view_.turn(wanted, haste, static_cast<float>(io_game.world().tick_s));
  net::Move move = move_for(self, steering);
  const float error = std::max(std::abs(turn_between_deg(view_.angles_deg().y, wanted.y)),
                               std::abs(turn_between_deg(view_.angles_deg().x, wanted.x)));
  if ((fight && fight->fires && error < fight->tolerance_deg) || (acts_fire_ && error < 2))
    move.buttons |= kAttackButton;
  move.impulse = static_cast<std::uint8_t>(pending_impulse_);
  return move;
}

void Brain::note_death(server::Game& io_game, const Self& self) {
  const server::Edict edict = io_game.player(setup_.slot);
  const vm::EntityIndex inflictor = edict[field::kDamageInflictor];
  const vm::EntityIndex owner = io_game.world().edicts.at(inflictor)[field::kOwner];
  std::string by = class_name(io_game, owner == vm::kWorld ? inflictor : owner);
  deaths_.push_back(fmt::format("by {} at {:.0f} {:.0f} {:.0f}, {}", by, self.origin.x, self.origin.y,
                                self.origin.z, describe()));
}

net::Move Brain::move_for(const Self& self, const Steering& steering) {
  net::Move move{.angles_deg = view_.angles_deg()};
  const math::Basis level = math::basis_from_angles({0, view_.angles_deg().y, 0});
  const math::Vec3 wish = steering.velocity;
  float forward = static_cast<float>(glm::dot(math::Vec3d(wish), level.forward));
  const float side = static_cast<float>(glm::dot(math::Vec3d(wish), level.right));
  float up = 0;
  if (self.swims()) {
    // Forward is along the view in water.
    const float pitch = view_.angles_deg().x * 0.01745329f;
    const float along = forward / std::max(std::cos(pitch), 0.3f);
    up = wish.z + along * std::sin(pitch);
    forward = along;
  }
  const auto bounded = [](float speed) {
    return static_cast<std::int16_t>(std::clamp(speed, -400.0f, 400.0f));
  };
  move.forward = bounded(forward);
  move.side = bounded(side);
  move.up = bounded(up);
  // Once a press.
  const bool jumps = steering.jumps && !jumped_;
  if (jumps) move.buttons |= kJumpButton;
  jumped_ = jumps;
  return move;
}

bool Brain::is_done(server::Game& io_game, const Self& self) const {
  const Task& task = *task_;
  if (task.opens >= 0) {
    const Mover& mover = map_->facts.movers[static_cast<std::size_t>(task.opens)];
    if (mover.key != 0) {
      if ((self.items & mover.key) != 0) return true;
    } else if (movers_.access(task.opens, mover.states - 1) <= Access::kSelf) {
      return mover.kind != MoverKind::kLift || movers_.access(task.opens, 0) <= Access::kSelf;
    }
  }
  server::GameWorld& world = io_game.world();
  if (!server::is_there(world, task.entity)) return true;
  const server::Edict edict = world.edicts[task.entity];
  switch (task.kind) {
    case TaskKind::kTake:
      return edict.solid() != server::Solid::kTrigger;
    case TaskKind::kKill:
      return edict[field::kHealth] <= 0;
    case TaskKind::kTouch:
      return io_game.machine().program().name_of(edict[field::kTouch]) == "nothing";
    default:
      return false;
  }
}

// Something that the rest of the way asks for cannot be had any more.
bool Brain::route_has_shut() const {
  for (const Way& way : task_->route.ways)
    for (const Demand& demand : way.demands)
      if (demand.mover >= 0 && movers_.access_any(demand.mover, demand.states) >= Access::kLocked &&
          !movers_.is_in(demand.mover, demand.states))
        return true;
  return false;
}

void Brain::take_up(Task task, double now_s) {
  task_ = std::move(task);
  phase_ = Phase::kWalk;
  phase_since_s_ = now_s;
  walker_.follow(task_->route, now_s);
}

void Brain::work(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if (task_ && is_done(io_game, self)) {
    if (!is_side_task_) {
      planner_.note_use(task_->entity);
      planned_.reset();
    }
    drop_task();
  }
  if (task_ && phase_ == Phase::kWalk && now_s - checked_route_s_ > kCheckRouteEvery_s) {
    checked_route_s_ = now_s;
    if (route_has_shut() && self.on_ground) drop_task();
  }
  const bool can_plan = self.on_ground || self.swims();
  if (task_ && !is_side_task_ && phase_ == Phase::kWalk && can_plan &&
      now_s - looked_for_items_s_ > kItemsEvery_s) {
    looked_for_items_s_ = now_s;
    const int at = map_->graph.nearest(self.origin);
    if (at >= 0)
      if (auto item = task_for_item(io_game, self, static_cast<std::uint32_t>(at))) {
        take_up(std::move(*item), now_s);
        is_side_task_ = true;
      }
  }
  if (!task_ && can_plan && now_s - planned_s_ > (in_vain_since_s_ ? kPlanEvery_s : 0.2))
    find_work(io_game, self, now_s);
  if (!task_) return;
  if (phase_ == Phase::kWalk) {
    switch (walker_.walk(io_game, self, now_s, out)) {
      case WalkEnd::kGoing:
        return;
      case WalkEnd::kLost:
        task_.reset();
        return;
      case WalkEnd::kArrived:
        phase_ = Phase::kAct;
        phase_since_s_ = now_s;
    }
  }
  act(io_game, self, now_s, out);
}

void Brain::act(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  const Task& task = *task_;
  if (now_s - phase_since_s_ > time_for(task.kind)) {
    if (is_side_task_)
      ++tried_items_[static_cast<std::uint32_t>(task.entity)];
    else
      give_up_task(self);
    drop_task();
    return;
  }
  const math::Bounds box = box_of(io_game.world().edicts.at(task.entity));
  const math::Vec3 middle = task.kind == TaskKind::kReach ? middle_of(task.box) : middle_of(box);
  const math::Vec3 way = middle - self.origin;
  const float level = glm::length(math::Vec2(way));
  out.look_at = middle;
  if (task.look != math::Vec3(0.0f)) out.look_at = self.eye() + task.look * 200.0f;
  if (task.kind == TaskKind::kShoot) {
    acts_fire_ = true;
    pending_impulse_ = Fighter::impulse_for_target(self, glm::distance(self.eye(), middle));
    return;
  }
  if (task.kind == TaskKind::kKill) return;
  if (level > kReachSlack_units)
    out.velocity = math::Vec3(way.x, way.y, 0) * (std::min(320.0f, 60 + level * 6) / level);
  if (self.swims()) out.velocity.z = std::clamp(way.z * 6, -300.0f, 300.0f);
  out.is_free = false;
}

void Brain::give_up_task(const Self& self) {
  planner_.note_vain(task_->entity, self.origin);
  planned_.reset();
}

std::vector<bool> Brain::premises(int items) const {
  std::vector<bool> premises;
  for (std::size_t i = 0; i < map_->facts.movers.size(); ++i)
    for (int state = 0; state < map_->facts.movers[i].states; ++state)
      premises.push_back(movers_.access(static_cast<int>(i), state) >= Access::kLocked);
  for (int bit = 0; bit < 24; ++bit) premises.push_back((items >> bit & 1) != 0 && bit >= 17 && bit <= 18);
  return premises;
}

std::optional<Task> Brain::interrupted_task(std::uint32_t at) {
  std::optional<Route> route = router_.find(at, planned_->goals);
  if (!route) return std::nullopt;
  Task task = *planned_;
  task.route = std::move(*route);
  return task;
}

void Brain::find_work(server::Game&, const Self& self, double now_s) {
  planned_s_ = now_s;
  is_side_task_ = false;
  const int at = map_->graph.nearest(self.origin);
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
  if (now_s - *in_vain_since_s_ > kDeadEndAfter_s && dead_ends_ < kMostDeadEnds) {
    ++dead_ends_;
    const math::Vec3 o = self.origin;
    complain(fmt::format("a dead end at {:.0f} {:.0f} {:.0f}: began again", o.x, o.y, o.z));
    in_vain_since_s_ = now_s;
    wants_to_begin_again_ = true;
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
