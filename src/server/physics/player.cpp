// Players: commands become velocity when they arrive (move_player), and velocity becomes motion in the tick
// (run_player). Other entities that walk move the same way, without QuakeC's functions for players.
#include "movement/player.h"

#include "math/angles.h"
#include "server/physics/crouch.h"
#include "server/physics/entity_moves.h"
#include "server/physics/moves.h"

namespace temblor::server {
namespace {

movement::MoveMode to_move_mode(MoveType type) {
  switch (type) {
    case MoveType::kNone:
      return movement::MoveMode::kStill;
    case MoveType::kWalk:
      return movement::MoveMode::kWalk;
    case MoveType::kFly:
      return movement::MoveMode::kFly;
    case MoveType::kNoClip:
      return movement::MoveMode::kNoClip;
    default:
      return movement::MoveMode::kThrown;
  }
}

// Whether nothing of the level is between the ends of the probe.
bool is_free(GameWorld& io_world, vm::EntityIndex player, const movement::EdgeProbe& probe) {
  constexpr math::Vec3 kPoint(0.0f);
  return trace_move(io_world, probe.start, kPoint, kPoint, probe.end, MoveKind::kNoMonsters, player)
             .trace.fraction == 1;
}

// Gets a player out of something solid: back to where it last was free, or to a free place close by. If there
// is none, it stays where it is.
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

// Walks, climbs steps, or swims for one tick. false: the entity was removed.
base::Result<bool> walk(GameWorld& io_world, vm::EntityIndex entity) {
  if (!check_water(io_world, entity) && !io_world.edicts[entity].has_flag(flag::kWaterJump))
    add_gravity(io_world, entity);
  TRY_STATUS(get_unstuck(io_world, entity));
  if (!is_there(io_world, entity)) return false;
  EntityEnvironment environment(io_world, entity);
  movement::Body body = environment.body();
  const math::Basis view = math::basis_from_angles(io_world.edicts[entity][field::kViewAngles]);
  TRY(const bool is_left,
      movement::walk(body, tick_seconds(io_world), math::Vec3(view.forward), environment));
  if (is_left) environment.store(body);
  return is_left;
}

base::Result<bool> fly(GameWorld& io_world, vm::EntityIndex entity) {
  EntityEnvironment environment(io_world, entity);
  movement::Body body = environment.body();
  TRY(const movement::Slide slide, movement::slide(body, tick_seconds(io_world), environment));
  if (!slide.is_gone) environment.store(body);
  return !slide.is_gone;
}

// Thinks and moves as the entity's move type says. false: it was removed on the way.
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
    edict.set(field::kOrigin, edict[field::kOrigin] + edict[field::kVelocity] * tick_seconds(io_world));
  }
  return true;
}

}  // namespace

movement::Player make_player(const GameWorld& world, const Edict& edict) {
  return {.body = make_body(edict),
          .mins_z = edict[field::kMins].z,
          .move_mode = to_move_mode(edict.move_type()),
          .is_alive = !(edict[field::kHealth] <= 0),
          .is_crouching = is_crouching(world, edict),
          .is_turned_by_game = edict[field::kFixAngle] != 0,
          .angles_deg = edict[field::kAngles],
          .punch_deg = edict[field::kPunchAngle],
          .water_level = edict.whole(field::kWaterLevel),
          .is_jumping_out_of_water = edict.has_flag(flag::kWaterJump),
          .water_jump_velocity = edict[field::kMoveDirection],
          .teleport_time_s = double{edict[field::kTeleportTime]} - world.time_s};
}

void move_player(GameWorld& io_world, vm::EntityIndex player, const PlayerCommand& command) {
  const Edict edict = io_world.edicts[player];
  edict.set(field::kViewAngles, command.view_angles_deg);
  crouch(io_world, player, command.up);
  movement::Player state = make_player(io_world, edict);
  if (state.move_mode == movement::MoveMode::kStill) return;
  const bool jumped_out_of_water = state.is_jumping_out_of_water;
  movement::apply_wishes(state, {command.view_angles_deg, {command.forward, command.side, command.up}},
                         io_world.settings, tick_seconds(io_world),
                         [&](const movement::EdgeProbe& probe) { return is_free(io_world, player, probe); });
  edict.set(field::kPunchAngle, state.punch_deg);
  edict.set(field::kAngles, state.angles_deg);
  edict.set(field::kVelocity, state.body.velocity);
  if (jumped_out_of_water && !state.is_jumping_out_of_water) {
    edict.clear_flag(flag::kWaterJump);
    edict.set(field::kTeleportTime, 0);
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
