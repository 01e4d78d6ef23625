// The order of a server's tick (server/physics/player.cpp): wishes, the program before the move, the move,
// and then the movers with whoever stands on them. Of programs that is known what the stock one does: jump.
#include "client/prediction/predicted_player.h"

#include <algorithm>

#include "math/angles.h"
#include "movement/walk.h"
#include "world/visibility.h"

namespace temblor::client {
namespace {

// Movetypes, as programs number them.
constexpr std::uint8_t kTypeNone = 0, kTypeWalk = 3, kTypeFly = 5, kTypeNoClip = 8;
constexpr std::uint8_t kJumpButton = 2;
constexpr float kJumpSpeed = 270;
constexpr float kSwimUpWater = 100, kSwimUpSlime = 80, kSwimUpLava = 50;
constexpr int kAtTheWaist = 2;
constexpr float kLedgeAhead = 24, kAboveLedge = 8, kLedgeSpeed = 50, kLedgeRise = 225;
constexpr double kLedgeJump_s = 2;
constexpr math::Bounds kPlayerBox{movement::kPlayerMins, movement::kPlayerMaxs};
constexpr math::Bounds kPoint{};
constexpr std::size_t kPassedOverForOne = 128;

movement::MoveMode gait_of(std::uint8_t move_type) {
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

class Surroundings final : public movement::WalkEnvironment {
 public:
  Surroundings(const PredictionWorld& world, const PredictedPlayer& predicted)
      : world_(world), predicted_(predicted) {}

  movement::Contact trace(const math::Vec3& start, const math::Vec3& end) override {
    return contact(kPlayerBox, start, end, 0);
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
    return contact(kPoint, start, end, 0).trace;
  }
  std::size_t effort() const { return effort_; }
  // Past one entity.
  math::Vec3 carried(const math::Vec3& start, const math::Vec3& end, std::uint32_t passing) const {
    return contact(kPlayerBox, start, end, passing).trace.end;
  }

 private:
  // What the origin of a box may touch of a model on its way there.
  static bool comes_near(const math::Bounds& bounds, const math::Vec3& origin, const math::Bounds& box,
                         const math::Vec3& start, const math::Vec3& end) {
    const math::Vec3 mins = glm::min(start, end) + box.mins, maxs = glm::max(start, end) + box.maxs;
    return glm::all(glm::lessThanEqual(mins, bounds.maxs + origin + 1.0f)) &&
           glm::all(glm::greaterThanEqual(maxs, bounds.mins + origin - 1.0f));
  }

  movement::Contact contact(const math::Bounds& box, const math::Vec3& start, const math::Vec3& end,
                            std::uint32_t passing) const {
    movement::Contact nearest;
    nearest.trace =
        world::trace_box_through(world_.level, world::ModelIndex{0}, math::Vec3(0.0f), box, start, end);
    nearest.hit = nearest.trace.fraction < 1 || nearest.trace.start_solid;
    nearest.can_stand_on = true;
    effort_ += 1 + world_.solids.size() / kPassedOverForOne;
    for (const SolidModel& solid : world_.solids) {
      if (passing != 0 && solid.entity == passing) continue;
      const bool is_ride = predicted_.ride && solid.entity == predicted_.ride_entity;
      const math::Vec3& origin = is_ride ? predicted_.ride->origin : solid.origin;
      const world::Model& model = world_.level.models[base::to_size(solid.model)];
      if (!comes_near(model.bounds, origin, box, start, end)) continue;
      ++effort_;
      const world::Trace trace = world::trace_box_through(world_.level, solid.model, origin, box, start, end);
      // Places of models are told in eighths of a unit: who seems to be in one only touches it.
      if (trace.start_solid || trace.fraction >= nearest.trace.fraction) continue;
      nearest = {trace, solid.entity, true, true};
    }
    return nearest;
  }

  const PredictionWorld& world_;
  const PredictedPlayer& predicted_;
  mutable std::size_t effort_ = 0;  // of all that was asked
};

// At the edge of a pool: a wall at the waist and nothing above the eyes lifts the swimmer out.
void jump_out_of_water_if_possible(PredictedPlayer& io_predicted, const PredictionWorld& world,
                                   const Surroundings& surroundings) {
  movement::Player& player = io_predicted.player;
  math::Vec3 ahead(math::basis_from_angles(player.angles_deg).forward);
  ahead.z = 0;
  if (ahead == math::Vec3(0.0f)) return;
  ahead = glm::normalize(ahead) * kLedgeAhead;
  const math::Vec3 waist = player.body.origin + math::Vec3(0, 0, kAboveLedge);
  const world::Trace wall = surroundings.line(waist, waist + ahead);
  if (wall.fraction == 1) return;
  player.water_jump_velocity = wall.plane_normal * -kLedgeSpeed;
  const math::Vec3 eyes = waist + math::Vec3(0, 0, world.eyes_z);
  if (surroundings.line(eyes, eyes + ahead).fraction < 1) return;
  player.is_jumping_out_of_water = true;
  io_predicted.is_jump_released = false;
  player.body.velocity.z = kLedgeRise;
  player.teleport_time_s = kLedgeJump_s;
}

// What the stock program does before each move.
void jump_if_wanted(PredictedPlayer& io_predicted, std::uint8_t buttons) {
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

void take_up_water(PredictedPlayer& io_predicted, const PredictionWorld& world) {
  movement::Player& player = io_predicted.player;
  const movement::WaterAround water = movement::water_around(
      player.body.origin, {.eyes = world.eyes_z},
      [&](const math::Vec3& point) { return world::point_contents(world.level, point); });
  player.water_level = water.level;
  io_predicted.swim_up_speed = water.at_feet == world::Contents::kSlime  ? kSwimUpSlime
                               : water.at_feet == world::Contents::kLava ? kSwimUpLava
                                                                         : kSwimUpWater;
}

void walk(PredictedPlayer& io_predicted, const net::Move& move, float duration_s,
          const PredictionWorld& world, Surroundings& io_surroundings) {
  movement::Player& player = io_predicted.player;
  take_up_water(io_predicted, world);
  if (player.water_level < movement::kSwimmingLevel && !player.is_jumping_out_of_water)
    player.body.velocity.z -= io_predicted.own_gravity * world.settings.gravity * duration_s;
  const math::Vec3 ahead(math::basis_from_angles(move.angles_deg).forward);
  movement::Body body = player.body;
  const base::Result<bool> walked = movement::walk(body, duration_s, ahead, io_surroundings);
  CHECK(walked.ok(), "nothing is called that could fail");
  player.body = body;
}

void ride_on(PredictedPlayer& io_predicted, float duration_s, const Surroundings& surroundings) {
  if (!io_predicted.ride) return;
  net::MoveAcknowledgement::Ride& ride = *io_predicted.ride;
  const float moved_s = std::min(ride.left_s, duration_s);
  const math::Vec3 way = ride.velocity * moved_s;
  ride.left_s -= moved_s;
  ride.origin += way;
  movement::Body& body = io_predicted.player.body;
  if (moved_s > 0 && body.on_ground && body.ground == io_predicted.ride_entity)
    body.origin = surroundings.carried(body.origin, body.origin + way, io_predicted.ride_entity);
}

}  // namespace

movement::Settings settings_of(const net::MoveParameters& terms) {
  return {.gravity = terms.gravity,
          .max_velocity = terms.max_velocity,
          .friction = terms.friction,
          .edge_friction = terms.edge_friction,
          .stop_speed = terms.stop_speed,
          .accelerate = terms.accelerate,
          .max_speed = terms.max_speed,
          .no_step = terms.no_step};
}

PredictedPlayer predicted_from(const net::MoveAcknowledgement& told) {
  return {.player = {.body = {told.origin, told.velocity, told.on_ground, told.ground},
                     .move_mode = gait_of(told.move_type),
                     .is_alive = told.is_alive,
                     .is_turned_by_game = told.is_turned_by_game,
                     .angles_deg = told.angles_deg,
                     .punch_deg = told.punch_deg,
                     .water_level = told.water_level,
                     .is_jumping_out_of_water = told.is_jumping_out_of_water,
                     .water_jump_velocity = math::Vec3(told.water_jump_velocity, 0),
                     .teleport_time_s = told.teleport_time_s > 0 ? double{told.teleport_time_s} : -1},
          .is_jump_released = told.is_jump_released,
          .swim_up_speed = told.is_in_slime  ? kSwimUpSlime
                           : told.is_in_lava ? kSwimUpLava
                                             : kSwimUpWater,
          .own_gravity = told.own_gravity,
          .ride_entity = told.ground,
          .ride = told.ride};
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
  Surroundings surroundings(world, io_predicted);
  const movement::Command command{
      move.angles_deg,
      {static_cast<float>(move.forward), static_cast<float>(move.side), static_cast<float>(move.up)}};
  movement::apply_wishes(player, command, world.settings, tick_s, [&](const movement::EdgeProbe& probe) {
    return surroundings.line(probe.start, probe.end).fraction == 1;
  });
  if (player.water_level == kAtTheWaist && player.move_mode != movement::MoveMode::kNoClip)
    jump_out_of_water_if_possible(io_predicted, world, surroundings);
  jump_if_wanted(io_predicted, move.buttons);
  player.body.velocity = movement::bounded(player.body.velocity, world.settings.max_velocity);
  if (player.move_mode == movement::MoveMode::kWalk) {
    walk(io_predicted, move, tick_s, world, surroundings);
  } else if (player.move_mode == movement::MoveMode::kFly) {
    const base::Result<movement::Slide> slid = movement::slide(player.body, tick_s, surroundings);
    CHECK(slid.ok(), "nothing is called that could fail");
  } else {
    player.body.origin += player.body.velocity * tick_s;
  }
  ride_on(io_predicted, tick_s, surroundings);
  player.teleport_time_s -= duration_s;
  return surroundings.effort();
}

}  // namespace temblor::client
