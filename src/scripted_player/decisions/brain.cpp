#include "scripted_player/decisions/brain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/angles.h"
#include "movement/player.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr double kPlanEvery_s = 2.5, kCheckRouteEvery_s = 0.4, kItemsEvery_s = 1.2;
constexpr double kSettle_s = 0.4, kFightsFirst_s = 20;
constexpr float kReachSlack_units = 4, kAim_deg = 2;
constexpr int kAttackButton = 1, kJumpButton = 2;
constexpr float kFleeHealth = 45, kFleeCost = 600;

// Seconds that an act may take.
double time_for(const Task& task) {
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

void Brain::begin_again(server::Game& io_game) {
  game_ = &io_game;
  movers_ = MoverWatch(map_->facts);
  router_.forgive();
  planner_ = Planner(io_game, map_->space, map_->graph, router_);
  fighter_ = Fighter(dice_, setup_.fights_players);
  tried_items_.clear();
  in_vain_since_s_.reset();
  planned_.reset();
  waypoint_ = stop_ = 0;
  has_pressed_ = false;
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
  planner_.set_shot_reach(Fighter::reach_for_target(self));
  Steering steering;
  steering.look_at = self.eye() + math::Vec3(math::basis_from_angles(view_.angles_deg()).forward) * 100.0f;
  fire_tolerance_deg_ = 0;
  pending_impulse_ = 0;
  // First onto the floor.
  if (settled_since_s_ == 0) settled_since_s_ = now_s;
  if (now_s - settled_since_s_ > kSettle_s) work(io_game, self, now_s, steering);

  std::optional<FightPlan> fight;
  if (setup_.fights && fire_tolerance_deg_ == 0) fight = fighter_.fight(io_game, self, now_s);
  float haste = 1;
  math::Vec3 wanted = angles_towards(self.eye(), steering.look_at);
  if (glm::length(math::Vec2(steering.look_at - self.eye())) < 12) wanted = view_.angles_deg();
  if (fire_tolerance_deg_ > 0)
    haste = 1.6f;
  else
    wanted.x *= 0.6f;
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
  if ((fight && fight->fires && error < fight->tolerance_deg) || error < fire_tolerance_deg_)
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
    case TaskKind::kPress:
      return task.stop > 0 && edict[field::kVelocity] != math::Vec3(0.0f);
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
  astray_since_s_.reset();
}

void Brain::work(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  if (task_ && is_done(io_game, self)) {
    if (!is_side_task_) {
      planner_.note_use(task_->entity);
      planned_.reset();
      if (task_->stop > 0) has_pressed_ = true;
    }
    drop_task();
  }
  if (task_ && phase_ == Phase::kWalk && now_s - checked_route_s_ > kCheckRouteEvery_s) {
    checked_route_s_ = now_s;
    if (route_has_shut() && self.on_ground) drop_task();
  }
  const bool can_plan = self.on_ground || self.swims();
  if (task_ && task_->stop == 0 && !is_side_task_ && phase_ == Phase::kWalk && can_plan &&
      now_s - looked_for_items_s_ > kItemsEvery_s) {
    looked_for_items_s_ = now_s;
    const int at = nearest_place(self);
    if (at >= 0)
      if (auto item = task_for_item(io_game, self, static_cast<std::uint32_t>(at))) {
        take_up(std::move(*item), now_s);
        is_side_task_ = true;
      }
  }
  if (!task_ && can_plan && now_s - planned_s_ > (in_vain_since_s_ ? kPlanEvery_s : 0.2))
    find_work(self, now_s);
  if (!task_) return find_back(io_game, self, now_s, out);
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

bool Brain::fights_first(double now_s) {
  if (!setup_.fights || !fighter_.has_enemy()) return false;
  if (now_s > fights_first_until_s_ + kFightsFirst_s) fights_first_until_s_ = now_s + kFightsFirst_s;
  return now_s < fights_first_until_s_;
}

void Brain::act(server::Game& io_game, const Self& self, double now_s, Steering& out) {
  const Task& task = *task_;
  // Those who stand before a target take the shots that are meant for it.
  if (task.kind == TaskKind::kShoot && fights_first(now_s)) return drop_task();
  if (now_s - phase_since_s_ > time_for(task)) {
    if (is_side_task_)
      ++tried_items_[static_cast<std::uint32_t>(task.entity)];
    else if (task.kind == TaskKind::kVisit)
      note_visited();
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
  if (task.kind == TaskKind::kVisit) return visit(self, now_s, out);
  if (task.kind == TaskKind::kShoot) {
    fire_tolerance_deg_ = kAim_deg;
    pending_impulse_ = Fighter::impulse_for_target(self, glm::distance(self.eye(), middle));
    return;
  }
  if (task.kind == TaskKind::kKill) return;
  if (level > kReachSlack_units)
    out.velocity = math::Vec3(way.x, way.y, 0) * (std::min(320.0f, 60 + level * 6) / level);
  if (self.swims()) out.velocity.z = std::clamp(way.z * 6, -300.0f, 300.0f);
  out.is_free = false;
}

}  // namespace temblor::player
