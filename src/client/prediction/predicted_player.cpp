// One tick in the server's order (server/physics/player.cpp): crouching, acceleration, the program before the
// move, the move, then movers and the players on them. The client knows only one part of the program, the
// stock player's jump.
#include "client/prediction/predicted_player.h"

#include <algorithm>

#include "math/angles.h"
#include "movement/crouch.h"
#include "movement/walk.h"
#include "world/visibility.h"

namespace temblor::client {
namespace {

// QuakeC's MOVETYPE_ numbers.
constexpr std::uint8_t kTypeNone = 0, kTypeWalk = 3, kTypeFly = 5, kTypeNoClip = 8;
constexpr std::uint8_t kJumpButton = 2;
// Speeds of the stock program, in units per second.
constexpr float kJumpSpeed = 270;
constexpr float kSwimUpWater = 100, kSwimUpSlime = 80, kSwimUpLava = 50;
constexpr int kWaistDeep = 2;
// Probes and speeds of the jump out of the water, in units and units per second.
constexpr float kLedgeAhead = 24, kAboveLedge = 8, kLedgeSpeed = 50, kLedgeRise = 225;
constexpr double kLedgeJump_s = 2;
constexpr math::Bounds kPoint{};
// Models that a box test rules out cost this small part of a trace.
constexpr std::size_t kSkippedPerEffort = 128;

movement::MoveMode to_move_mode(std::uint8_t move_type) {
  switch (move_type) {
    case kTypeNone:
      return movement::MoveMode::kStill;
    case kTypeWalk:
      return movement::MoveMode::kWalk;
    case kTypeFly:
      return movement::MoveMode::kFly;
    case kTypeNoClip:
      return movement::MoveMode::kNoClip;
    default:
      return movement::MoveMode::kThrown;
  }
}

math::Bounds make_player_box(const movement::Player& player) {
  return {movement::kPlayerMins, player.is_crouching ? movement::kCrouchedMaxs : movement::kPlayerMaxs};
}

float compute_height(const math::Bounds& box) {
  return box.maxs.z - box.mins.z;
}

// Traces through the level and the solids, and counts the effort.
class PredictionTracer final : public movement::WalkEnvironment {
 public:
  PredictionTracer(const PredictionWorld& world, const PredictedPlayer& predicted)
      : world_(world), predicted_(predicted), box_(make_player_box(predicted.player)) {}

  movement::Contact trace(const math::Vec3& start, const math::Vec3& end) override {
    return trace_all(box_, start, end, 0);
  }
  movement::Contact trace_push(const math::Vec3& start, const math::Vec3& end) override {
    return trace(start, end);
  }
  base::Result<bool> touch(const movement::Contact&, movement::Body&) override { return true; }
  base::Result<bool> moved(movement::Body&) override { return true; }
  bool may_climb(bool was_on_ground) override {
    const movement::Player& player = predicted_.player;
    return (was_on_ground || player.water_level != 0) && !world_.settings.no_step &&
           !player.is_jumping_out_of_water;
  }

  world::Trace line(const math::Vec3& start, const math::Vec3& end) const {
    return trace_all(kPoint, start, end, 0).trace;
  }
  std::size_t effort() const { return effort_; }
  // Whether a crouching player has space to stand up.
  bool can_stand_up() const {
    const math::Vec3 up(0, 0,
                        compute_height(world::kHalfLifeHulls[0]) - compute_height(world::kHalfLifeHulls[2]));
    const math::Vec3& origin = predicted_.player.body.origin;
    return trace_all(box_, origin, origin + up, 0).trace.fraction == 1;
  }
  // Traces past one entity: the one that carries the player.
  math::Vec3 trace_carried(const math::Vec3& start, const math::Vec3& end, std::uint32_t passing) const {
    return trace_all(box_, start, end, passing).trace.end;
  }

 private:
  // Whether a box that moves from `start` to `end` comes near a model; with a margin of a unit.
  static bool is_near_path(const math::Bounds& bounds, const math::Vec3& origin, const math::Bounds& box,
                           const math::Vec3& start, const math::Vec3& end) {
    const math::Vec3 mins = glm::min(start, end) + box.mins, maxs = glm::max(start, end) + box.maxs;
    return glm::all(glm::lessThanEqual(mins, bounds.maxs + origin + 1.0f)) &&
           glm::all(glm::greaterThanEqual(maxs, bounds.mins + origin - 1.0f));
  }

  // Returns the nearest contact with the level or a model. `passing`: an entity to pass through; 0 for none.
  // The player's ride is traced where the prediction has moved it.
  movement::Contact trace_all(const math::Bounds& box, const math::Vec3& start, const math::Vec3& end,
                              std::uint32_t passing) const {
    movement::Contact nearest;
    nearest.trace =
        world::trace_box_through_model(world_.level, world::ModelIndex{0}, math::Vec3(0.0f), box, start, end);
    nearest.hit = nearest.trace.fraction < 1 || nearest.trace.start_solid;
    nearest.can_stand_on = true;
    effort_ += 1 + world_.solids.size() / kSkippedPerEffort;
    for (const SolidModel& solid : world_.solids) {
      if (passing != 0 && solid.entity == passing) continue;
      const bool is_ride = predicted_.ride && solid.entity == predicted_.ride_entity;
      const math::Vec3& origin = is_ride ? predicted_.ride->origin : solid.origin;
      const world::Model& model = world_.level.models[base::to_size(solid.model)];
      if (!is_near_path(model.bounds, origin, box, start, end)) continue;
      ++effort_;
      const world::Trace trace =
          world::trace_box_through_model(world_.level, solid.model, origin, box, start, end);
      // Origins of models travel in eighths of a unit, so a player who seems to be inside one only touches
      // it.
      if (trace.start_solid || trace.fraction >= nearest.trace.fraction) continue;
      nearest = {trace, solid.entity, true, true};
    }
    return nearest;
  }

  const PredictionWorld& world_;
  const PredictedPlayer& predicted_;
  const math::Bounds box_;
  mutable std::size_t effort_ = 0;  // of all traces so far
};

// Crouches as the server does (server/physics/crouch.h), and returns the effort. A box of the game code's own
// is not known here.
std::size_t crouch(PredictedPlayer& io_predicted, float wish_up, float tick_s, const PredictionWorld& world) {
  if (!world.level.is_half_life) return 0;
  const PredictionTracer tracer(world, io_predicted);
  io_predicted.player.is_crouching =
      movement::is_crouching_next(io_predicted.player, wish_up, [&] { return tracer.can_stand_up(); });
  if (io_predicted.player.move_mode == movement::MoveMode::kWalk)
    io_predicted.eyes_z = movement::move_eyes(io_predicted.eyes_z, io_predicted.player.is_crouching, tick_s);
  return tracer.effort();
}

// At the edge of a pool, a wall at the waist and free space at the eyes lets the swimmer jump out.
void try_jump_out_of_water(PredictedPlayer& io_predicted, const PredictionTracer& tracer) {
  movement::Player& player = io_predicted.player;
  math::Vec3 ahead(math::basis_from_angles(player.angles_deg).forward);
  ahead.z = 0;
  if (ahead == math::Vec3(0.0f)) return;
  ahead = glm::normalize(ahead) * kLedgeAhead;
  const math::Vec3 waist = player.body.origin + math::Vec3(0, 0, kAboveLedge);
  const world::Trace wall = tracer.line(waist, waist + ahead);
  if (wall.fraction == 1) return;
  player.water_jump_velocity = wall.plane_normal * -kLedgeSpeed;
  const math::Vec3 eyes = waist + math::Vec3(0, 0, io_predicted.eyes_z);
  if (tracer.line(eyes, eyes + ahead).fraction < 1) return;
  player.is_jumping_out_of_water = true;
  io_predicted.is_jump_released = false;
  player.body.velocity.z = kLedgeRise;
  player.teleport_time_s = kLedgeJump_s;
}

// The stock program's PlayerPreThink, as far as it moves the player: jumping and swimming up.
void apply_jump_button(PredictedPlayer& io_predicted, std::uint8_t buttons) {
  if ((buttons & kJumpButton) == 0) {
    io_predicted.is_jump_released = true;
    return;
  }
  movement::Player& player = io_predicted.player;
  if (player.is_jumping_out_of_water) return;
  if (player.water_level >= movement::kSwimmingLevel) {
    player.body.velocity.z = io_predicted.swim_up_speed;
    return;
  }
  if (!player.body.on_ground || !io_predicted.is_jump_released) return;
  io_predicted.is_jump_released = false;
  player.body.on_ground = false;
  player.body.velocity.z += kJumpSpeed;
}

// The water level is found before the move, as the server does.
void update_water_level(PredictedPlayer& io_predicted, const PredictionWorld& world) {
  movement::Player& player = io_predicted.player;
  const movement::Water water = movement::find_water(
      player.body.origin, {.maxs = make_player_box(player).maxs.z, .eyes = io_predicted.eyes_z},
      [&](const math::Vec3& point) { return world::point_contents(world.level, point, world.liquids); });
  player.water_level = water.level;
  io_predicted.swim_up_speed = water.at_feet == world::Contents::kSlime  ? kSwimUpSlime
                               : water.at_feet == world::Contents::kLava ? kSwimUpLava
                                                                         : kSwimUpWater;
}

// Gravity, then a walk with steps up and down, as on the server. The tracer's touch() and moved() always
// succeed, so walking cannot fail.
void walk(PredictedPlayer& io_predicted, const net::Move& move, float duration_s,
          const PredictionWorld& world, PredictionTracer& io_tracer) {
  movement::Player& player = io_predicted.player;
  update_water_level(io_predicted, world);
  if (player.water_level < movement::kSwimmingLevel && !player.is_jumping_out_of_water)
    player.body.velocity.z -= io_predicted.own_gravity * world.settings.gravity * duration_s;
  const math::Vec3 ahead(math::basis_from_angles(move.angles_deg).forward);
  movement::Body body = player.body;
  const base::Result<bool> walked = movement::walk(body, duration_s, ahead, io_tracer);
  CHECK(walked.ok(), "nothing is called that could fail");
  player.body = body;
}

// Moves the mover under the player, and the player with it. Its velocity is known only for `left_s`; then it
// stays.
void advance_ride(PredictedPlayer& io_predicted, float duration_s, const PredictionTracer& tracer) {
  if (!io_predicted.ride) return;
  net::MoveAcknowledgment::Ride& ride = *io_predicted.ride;
  const float moved_s = std::min(ride.left_s, duration_s);
  const math::Vec3 way = ride.velocity * moved_s;
  ride.left_s -= moved_s;
  ride.origin += way;
  movement::Body& body = io_predicted.player.body;
  if (moved_s > 0 && body.on_ground && body.ground == io_predicted.ride_entity)
    body.origin = tracer.trace_carried(body.origin, body.origin + way, io_predicted.ride_entity);
}

}  // namespace

PredictedPlayer make_predicted_player(const net::MoveAcknowledgment& acknowledged) {
  return {.player = {.body = {acknowledged.origin, acknowledged.velocity, acknowledged.on_ground,
                              acknowledged.ground},
                     .move_mode = to_move_mode(acknowledged.move_type),
                     .is_alive = acknowledged.is_alive,
                     .is_crouching = acknowledged.is_crouching,
                     .is_turned_by_game = acknowledged.is_turned_by_game,
                     .angles_deg = acknowledged.angles_deg,
                     .punch_deg = acknowledged.punch_deg,
                     .water_level = acknowledged.water_level,
                     .is_jumping_out_of_water = acknowledged.is_jumping_out_of_water,
                     .water_jump_velocity = math::Vec3(acknowledged.water_jump_velocity, 0),
                     .teleport_time_s =
                         acknowledged.teleport_time_s > 0 ? double{acknowledged.teleport_time_s} : -1},
          .is_jump_released = acknowledged.is_jump_released,
          .swim_up_speed = acknowledged.is_in_slime  ? kSwimUpSlime
                           : acknowledged.is_in_lava ? kSwimUpLava
                                                     : kSwimUpWater,
          .own_gravity = acknowledged.own_gravity,
          .ride_entity = acknowledged.ground,
          .ride = acknowledged.ride};
}

bool is_predictable(const PredictedPlayer& predicted) {
  const movement::MoveMode move_mode = predicted.player.move_mode;
  return predicted.player.is_alive && move_mode != movement::MoveMode::kStill &&
         move_mode != movement::MoveMode::kThrown;
}

std::size_t step(PredictedPlayer& io_predicted, const net::Move& move, double duration_s,
                 const PredictionWorld& world) {
  movement::Player& player = io_predicted.player;
  const auto tick_s = static_cast<float>(duration_s);
  const std::size_t crouch_effort = crouch(io_predicted, static_cast<float>(move.up), tick_s, world);
  PredictionTracer tracer(world, io_predicted);
  const movement::Command command{
      move.angles_deg,
      {static_cast<float>(move.forward), static_cast<float>(move.side), static_cast<float>(move.up)}};
  movement::apply_wishes(player, command, world.settings, tick_s, [&](const movement::EdgeProbe& probe) {
    return tracer.line(probe.start, probe.end).fraction == 1;
  });
  if (player.water_level == kWaistDeep && player.move_mode != movement::MoveMode::kNoClip)
    try_jump_out_of_water(io_predicted, tracer);
  apply_jump_button(io_predicted, move.buttons);
  player.body.velocity = movement::limit_velocity(player.body.velocity, world.settings.max_velocity);
  if (player.move_mode == movement::MoveMode::kWalk) {
    walk(io_predicted, move, tick_s, world, tracer);
  } else if (player.move_mode == movement::MoveMode::kFly) {
    const base::Result<movement::Slide> slid = movement::slide(player.body, tick_s, tracer);
    CHECK(slid.ok(), "nothing is called that could fail");
  } else {
    player.body.origin += player.body.velocity * tick_s;
  }
  advance_ride(io_predicted, tick_s, tracer);
  player.teleport_time_s -= duration_s;
  return crouch_effort + tracer.effort();
}

}  // namespace temblor::client
