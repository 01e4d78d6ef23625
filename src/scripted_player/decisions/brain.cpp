#include "scripted_player/decisions/brain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/angles.h"
#include "movement/player.h"

namespace temblor::player {
namespace {

namespace field = server::field;

// kPlanEvery_s applies while nothing can be reached; otherwise planning is due as soon as a task ends.
constexpr double kPlanEvery_s = 2.5, kCheckRouteEvery_s = 0.4, kItemsEvery_s = 1.2;
// Time to fall to the floor after a spawn, and how long a fight may delay a shot at a button.
constexpr double kSettle_s = 0.4, kFightsFirst_s = 20;
constexpr float kReachSlack_units = 4, kAim_deg = 2;
// Bits of net::Move::buttons.
constexpr int kAttackButton = 1, kJumpButton = 2;
// Below this health the player does not stop to fight if an item is within this cost.
constexpr float kFleeHealth = 45, kFleeCost = 600;

// Returns the seconds that the act of a task may take before it counts as failed.
double max_act_time_s(const Task& task) {
  switch (task.kind) {
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
    case TaskKind::kVisit:
      return task.stay_s;
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
      fighter_(dice_, setup.fights_players) {}

// Secrets that were abandoned, penalties of dead ends, and problems stay; everything else starts over.
void Brain::restart(server::Game& io_game) {
  game_ = &io_game;
  movers_ = MoverWatch(map_->facts);
  router_.clear_penalties();
  planner_ = Planner(io_game, map_->space, map_->graph, router_);
  fighter_ = Fighter(dice_, setup_.fights_players);
  item_attempts_.clear();
  stalled_since_s_.reset();
  planned_.reset();
  waypoint_ = stop_ = 0;
  has_pressed_ = false;
  drop_task();
}

std::string Brain::describe() const {
  if (!task_) return "has no task";
  return fmt::format("task: {}: {}", task_->description,
                     phase_ == Phase::kAct ? "performs it" : walker_.describe());
}

void Brain::report_problem(const std::string& text) {
  if (std::find(problems_.begin(), problems_.end(), text) == problems_.end()) problems_.push_back(text);
}

// One tick: observe, follow the task, let the fighter override movement and view, turn the view, and fire if
// it is on the target. A shot for the task (fire_tolerance_deg_) has priority over the fight.
net::Move Brain::think(server::Game& io_game, std::optional<math::Vec3> view_deg, double now_s) {
  ++tick_;
  const Self self = read_self(io_game, setup_.slot);
  if (view_deg) view_.set(*view_deg);
  if (!self.is_alive()) {
    const bool is_dead = io_game.player(setup_.slot)[field::kDeadFlag] != 0;
    if (was_alive_ && is_dead) record_death(io_game, self);
    was_alive_ = was_alive_ && !is_dead;
    drop_task();
    settled_since_s_ = now_s;
    // Respawn: press the attack button now and then, because game code waits for its release between two
    // presses.
    net::Move move{.angles_deg = view_.angles_deg()};
    move.buttons = tick_ % 40 == 0 ? kAttackButton : 0;
    return move;
  }
  if (!was_alive_) stalled_since_s_.reset();
  was_alive_ = true;
  movers_.look(io_game, self.items);
  planner_.set_items(self.items);
  planner_.set_shot_reach(Fighter::reach_for_target(self));
  Steering steering;
  steering.look_at = self.eye() + math::Vec3(math::basis_from_angles(view_.angles_deg()).forward) * 100.0f;
  fire_tolerance_deg_ = 0;
  pending_impulse_ = 0;
  if (settled_since_s_ == 0) settled_since_s_ = now_s;
  if (now_s - settled_since_s_ > kSettle_s) advance_task(io_game, self, now_s, steering);

  std::optional<FightPlan> fight;
  if (setup_.fights && fire_tolerance_deg_ == 0) fight = fighter_.fight(io_game, self, now_s);
  float haste = 1;
  // Keep the view while looking at a point right above or below, whose yaw is undefined. On a walk, look less
  // steeply up or down than the route leads.
  math::Vec3 wanted = angles_toward(self.eye(), steering.look_at);
  if (glm::length(math::Vec2(steering.look_at - self.eye())) < 12) wanted = view_.angles_deg();
  if (fire_tolerance_deg_ > 0)
    haste = 1.6f;
  else
    wanted.x *= 0.6f;
  if (fight) {
    haste = 2.2f;
    wanted = angles_toward(self.eye(), fight->aim_at);
    // Badly wounded and on the way to an item nearby, the player fights without stopping.
    const bool flees = self.health < kFleeHealth && is_side_task_ && task_ && task_->route.cost < kFleeCost;
    if (steering.is_free && fight->stands_ground && !flees) {
      steering.velocity = fight->velocity;
      steering.jumps = false;
    }
    pending_impulse_ = fight->impulse;
  }
  view_.turn(wanted, haste, static_cast<float>(io_game.world().tick_s));
  net::Move move = make_move(self, steering);
  const float error = std::max(std::abs(angle_difference_deg(view_.angles_deg().y, wanted.y)),
                               std::abs(angle_difference_deg(view_.angles_deg().x, wanted.x)));
  if ((fight && fight->fires && error < fight->tolerance_deg) || error < fire_tolerance_deg_)
    move.buttons |= kAttackButton;
  move.impulse = static_cast<std::uint8_t>(pending_impulse_);
  return move;
}

void Brain::record_death(server::Game& io_game, const Self& self) {
  const server::Edict edict = io_game.player(setup_.slot);
  const vm::EntityIndex inflictor = edict[field::kDamageInflictor];
  const vm::EntityIndex owner = io_game.world().edicts.at(inflictor)[field::kOwner];
  std::string by = class_name(io_game, owner == vm::kWorld ? inflictor : owner);
  deaths_.push_back(fmt::format("by {} at {:.0f} {:.0f} {:.0f}, {}", by, self.origin.x, self.origin.y,
                                self.origin.z, describe()));
}

// Converts the wanted velocity from world space to the forward, side, and up speeds of a move, as a client
// sends them.
net::Move Brain::make_move(const Self& self, const Steering& steering) {
  net::Move move{.angles_deg = view_.angles_deg()};
  const math::Basis level = math::basis_from_angles({0, view_.angles_deg().y, 0});
  const math::Vec3 wish = steering.velocity;
  float forward = static_cast<float>(glm::dot(math::Vec3d(wish), level.forward));
  const float side = static_cast<float>(glm::dot(math::Vec3d(wish), level.right));
  float up = 0;
  if (self.swims()) {
    // In water, forward is along the view, including its pitch: compensate, so that the vertical speed is as
    // wanted.
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
  // Release the jump button after each jump, because stock Quake jumps only once per press.
  const bool jumps = steering.jumps && !jumped_;
  if (jumps) move.buttons |= kJumpButton;
  jumped_ = jumps;
  return move;
}

// A task is done when its effect has happened, however that came about: another player may have opened the
// door.
bool Brain::is_done(server::Game& io_game, const Self& self) const {
  const Task& task = *task_;
  if (task.opens >= 0) {
    const Mover& mover = map_->facts.movers[static_cast<std::size_t>(task.opens)];
    if (mover.key != 0) {
      if ((self.items & mover.key) != 0) return true;
    } else if (movers_.access(task.opens, mover.states - 1) <= Access::kAutomatic) {
      return mover.kind != MoverKind::kLift || movers_.access(task.opens, 0) <= Access::kAutomatic;
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
      return io_game.machine().program().function_name(edict[field::kTouch]) == "nothing";
    case TaskKind::kPress:
      return task.stop > 0 && edict[field::kVelocity] != math::Vec3(0.0f);
    default:
      return false;
  }
}

// Returns whether a mover on the route is not in the state that the route needs and can no longer get into it
// on its own.
bool Brain::is_route_blocked() const {
  for (const Link& link : task_->route.links)
    for (const MoverCondition& condition : link.conditions)
      if (condition.mover >= 0 && movers_.access_any(condition.mover, condition.states) >= Access::kLocked &&
          !movers_.is_in(condition.mover, condition.states))
        return true;
  return false;
}

void Brain::start_task(Task task, double now_s) {
  task_ = std::move(task);
  phase_ = Phase::kWalk;
  phase_since_s_ = now_s;
  walker_.follow(task_->route, now_s);
  lost_since_s_.reset();
}

// In order: end a task that is done, drop one whose route is blocked, consider a detour, plan if there is no
// task, and then walk or perform the task.
void Brain::advance_task(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if (task_ && is_done(io_game, self)) {
    if (!is_side_task_) {
      planner_.record_use(task_->entity);
      planned_.reset();
      if (task_->stop > 0) has_pressed_ = true;
    }
    drop_task();
  }
  if (task_ && phase_ == Phase::kWalk && now_s - checked_route_s_ > kCheckRouteEvery_s) {
    checked_route_s_ = now_s;
    if (is_route_blocked() && self.on_ground) drop_task();
  }
  const bool can_plan = self.on_ground || self.swims();
  if (task_ && task_->stop == 0 && !is_side_task_ && phase_ == Phase::kWalk && can_plan &&
      now_s - looked_for_items_s_ > kItemsEvery_s) {
    looked_for_items_s_ = now_s;
    const int at = nearest_place(self);
    if (at >= 0)
      if (auto item = plan_detour(io_game, self, static_cast<std::uint32_t>(at))) {
        start_task(std::move(*item), now_s);
        is_side_task_ = true;
      }
  }
  if (!task_ && can_plan && now_s - planned_s_ > (stalled_since_s_ ? kPlanEvery_s : 0.2))
    choose_task(self, now_s);
  if (!task_) return return_to_graph(io_game, self, now_s, out);
  if (phase_ == Phase::kWalk) {
    switch (walker_.walk(io_game, self, now_s, out)) {
      case WalkResult::kGoing:
        return;
      case WalkResult::kLost:
        task_.reset();
        return;
      case WalkResult::kArrived:
        phase_ = Phase::kAct;
        phase_since_s_ = now_s;
    }
  }
  perform_task(io_game, self, now_s, out);
}

// Alternates: at most kFightsFirst_s of fighting, then the same time for the task.
bool Brain::should_fight_first(double now_s) {
  if (!setup_.fights || !fighter_.has_enemy()) return false;
  if (now_s > fights_first_until_s_ + kFightsFirst_s) fights_first_until_s_ = now_s + kFightsFirst_s;
  return now_s < fights_first_until_s_;
}

// Acts at the end of the route: walks into the entity (press, touch, take, reach), shoots at it, stays
// (visit), or lets the fighter kill it. An act that takes too long has failed.
void Brain::perform_task(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  const Task& task = *task_;
  // Kill enemies first, because one that stands in front of the target takes the shots that are meant for it.
  if (task.kind == TaskKind::kShoot && should_fight_first(now_s)) return drop_task();
  if (now_s - phase_since_s_ > max_act_time_s(task)) {
    if (is_side_task_)
      ++item_attempts_[static_cast<std::uint32_t>(task.entity)];
    else if (task.kind == TaskKind::kVisit)
      finish_stop();
    else
      abandon_task(self);
    drop_task();
    return;
  }
  const math::Bounds box = entity_box(io_game.world().edicts.at(task.entity));
  const math::Vec3 middle = task.kind == TaskKind::kReach ? box_center(task.box) : box_center(box);
  const math::Vec3 offset = middle - self.origin;
  const float level = glm::length(math::Vec2(offset));
  out.look_at = middle;
  if (task.look != math::Vec3(0.0f)) out.look_at = self.eye() + task.look * 200.0f;
  if (task.kind == TaskKind::kVisit) return visit(self, now_s, out);
  if (task.kind == TaskKind::kShoot) {
    fire_tolerance_deg_ = kAim_deg;
    pending_impulse_ = Fighter::impulse_for_target(self, glm::distance(self.eye(), middle));
    return;
  }
  if (task.kind == TaskKind::kKill) return;
  if (level > kReachSlack_units)
    out.velocity = math::Vec3(offset.x, offset.y, 0) * (std::min(320.0f, 60 + level * 6) / level);
  if (self.swims()) out.velocity.z = std::clamp(offset.z * 6, -300.0f, 300.0f);
  out.is_free = false;
}

}  // namespace temblor::player
