// Players: their wishes become velocity when their commands arrive, their velocity a way in the tick. Others
// who walk go the same way without the program's functions for players.
#include "math/angles.h"
#include "movement/velocity.h"
#include "server/physics/entity_moves.h"
#include "server/physics/moves.h"

namespace temblor::server {
namespace {

// A model shows a third of its player's pitch, and leans more than the view.
constexpr float kModelPitch = -1.0f / 3, kModelRoll = 4;

movement::Wish wish_of(const PlayerCommand& command) {
  return {command.forward, command.side, command.up};
}

bool is_at_edge(GameWorld& io_world, const Edict& edict) {
  const math::Vec3 velocity = edict[field::kVelocity];
  if (velocity.x == 0 && velocity.y == 0) return false;
  const movement::EdgeProbe probe =
      movement::edge_probe(edict[field::kOrigin], edict[field::kMins].z, velocity);
  constexpr math::Vec3 kPoint(0.0f);
  return trace_move(io_world, probe.start, kPoint, kPoint, probe.end, MoveKind::kNoMonsters, edict.index())
             .trace.fraction == 1;
}

// On foot, in the air, or through everything.
math::Vec3 velocity_out_of_water(GameWorld& io_world, const Edict& edict, const PlayerCommand& command) {
  const movement::Settings& settings = io_world.settings;
  movement::Wish wish = wish_of(command);
  // Out of a teleporter nobody backs into it again by accident.
  if (io_world.time_s < double{edict[field::kTeleportTime]} && wish.forward < 0) wish.forward = 0;
  math::Vec3 wished = movement::wish_velocity(edict[field::kAngles], wish);
  const MoveType type = edict.move_type();
  wished.z = type == MoveType::kWalk ? 0 : wish.up;
  wished = movement::capped(wished, settings.max_speed);

  if (type == MoveType::kNoClip) return wished;
  const math::Vec3 velocity = edict[field::kVelocity];
  if (!edict.has_flag(flag::kOnGround))
    return movement::accelerated_in_air(velocity, wished, settings, tick_of(io_world));
  const math::Vec3 slowed =
      movement::slowed_on_ground(velocity, settings, tick_of(io_world), is_at_edge(io_world, edict));
  return movement::accelerated_on_ground(slowed, wished, settings, tick_of(io_world));
}

// Out of the water onto a ledge: the program has given the way; it lasts until its time is over, or the
// water.
void jump_out_of_water(const GameWorld& world, const Edict& edict) {
  if (world.time_s > double{edict[field::kTeleportTime]} || edict[field::kWaterLevel] == 0) {
    edict.clear_flag(flag::kWaterJump);
    edict.set(field::kTeleportTime, 0);
  }
  const math::Vec3 direction = edict[field::kMoveDirection];
  edict.set(field::kVelocity, {direction.x, direction.y, edict[field::kVelocity].z});
}

void turn_model(const Edict& edict, const math::Vec3& view_deg) {
  math::Vec3 angles = edict[field::kAngles];
  angles.z = movement::roll_deg(angles, edict[field::kVelocity]) * kModelRoll;
  if (edict[field::kFixAngle] == 0) {
    angles.x = view_deg.x * kModelPitch;
    angles.y = view_deg.y;
  }
  edict.set(field::kAngles, angles);
}

// In something solid: back to where it last was not, or to a free place close by.
base::Status get_unstuck(GameWorld& io_world, vm::EntityIndex entity) {
  constexpr int kHeights = 18;
  const Edict edict = io_world.edicts[entity];
  const math::Vec3 origin = edict[field::kOrigin];
  if (!is_stuck(io_world, entity)) {
    edict.set(field::kOldOrigin, origin);
    return base::Ok{};
  }
  const auto fits_at = [&](const math::Vec3& place) {
    edict.set(field::kOrigin, place);
    return !is_stuck(io_world, entity);
  };
  if (fits_at(edict[field::kOldOrigin])) return link(io_world, entity, TouchTriggers::kYes);
  for (int z = 0; z < kHeights; ++z)
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        if (fits_at(origin + math::Vec3(x, y, z))) return link(io_world, entity, TouchTriggers::kYes);
  edict.set(field::kOrigin, origin);
  return base::Ok{};
}

// false: it is gone.
base::Result<bool> walk(GameWorld& io_world, vm::EntityIndex entity) {
  if (!check_water(io_world, entity) && !io_world.edicts[entity].has_flag(flag::kWaterJump))
    add_gravity(io_world, entity);
  TRY_STATUS(get_unstuck(io_world, entity));
  if (!is_there(io_world, entity)) return false;
  EntityEnvironment environment(io_world, entity);
  movement::Body body = environment.body();
  const math::Basis view = math::basis_from_angles(io_world.edicts[entity][field::kViewAngles]);
  TRY(const bool is_left, movement::walk(body, tick_of(io_world), math::Vec3(view.forward), environment));
  if (is_left) environment.store(body);
  return is_left;
}

base::Result<bool> fly(GameWorld& io_world, vm::EntityIndex entity) {
  EntityEnvironment environment(io_world, entity);
  movement::Body body = environment.body();
  TRY(const movement::Slide slide, movement::slide(body, tick_of(io_world), environment));
  if (!slide.is_gone) environment.store(body);
  return !slide.is_gone;
}

// A tick by the entity's move type; false: it is gone, or was removed by its own think.
base::Result<bool> think_and_move(GameWorld& io_world, vm::EntityIndex entity) {
  const MoveType type = io_world.edicts[entity].move_type();
  if (type == MoveType::kToss || type == MoveType::kBounce || type == MoveType::kFlyMissile) {
    TRY_STATUS(run_thrown(io_world, entity));
    return is_there(io_world, entity);
  }
  TRY(const bool is_left, run_think(io_world, entity));
  if (!is_left) return false;
  if (type == MoveType::kWalk) return walk(io_world, entity);
  if (type == MoveType::kFly) return fly(io_world, entity);
  if (type == MoveType::kNoClip) {
    const Edict edict = io_world.edicts[entity];
    edict.set(field::kOrigin, edict[field::kOrigin] + edict[field::kVelocity] * tick_of(io_world));
  }
  return true;
}

}  // namespace

void move_player(GameWorld& io_world, vm::EntityIndex player, const PlayerCommand& command) {
  const Edict edict = io_world.edicts[player];
  edict.set(field::kViewAngles, command.view_angles_deg);
  if (edict.move_type() == MoveType::kNone) return;
  const math::Vec3 punch = edict[field::kPunchAngle];
  edict.set(field::kPunchAngle, movement::faded_punch(punch, tick_of(io_world)));
  if (edict[field::kHealth] <= 0) return;

  turn_model(edict, command.view_angles_deg + edict[field::kPunchAngle]);
  if (edict.has_flag(flag::kWaterJump)) {
    jump_out_of_water(io_world, edict);
  } else if (edict[field::kWaterLevel] >= 2 && edict.move_type() != MoveType::kNoClip) {
    edict.set(field::kVelocity, movement::swum(edict[field::kVelocity], command.view_angles_deg,
                                               wish_of(command), io_world.settings, tick_of(io_world)));
  } else {
    edict.set(field::kVelocity, velocity_out_of_water(io_world, edict, command));
  }
}

base::Status run_player(GameWorld& io_world, vm::EntityIndex player, const TickFunctions& functions) {
  TRY_STATUS(io_world.calls.call(functions.player_pre_think, player, vm::kWorld, io_world.time_s));
  check_velocity(io_world, player);
  TRY(const bool is_left, think_and_move(io_world, player));
  if (!is_left) return base::Ok{};
  TRY_STATUS(link(io_world, player, TouchTriggers::kYes));
  return io_world.calls.call(functions.player_post_think, player, vm::kWorld, io_world.time_s);
}

base::Status run_walker(GameWorld& io_world, vm::EntityIndex entity) {
  check_velocity(io_world, entity);
  TRY(const bool is_left, think_and_move(io_world, entity));
  return is_left ? link(io_world, entity, TouchTriggers::kYes) : base::Status(base::Ok{});
}

}  // namespace temblor::server
