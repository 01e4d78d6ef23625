#include "server/physics/crouch.h"

#include "movement/crouch.h"
#include "movement/player.h"
#include "server/move_trace.h"
#include "server/physics/entity_moves.h"
#include "server/physics/physics.h"

namespace temblor::server {
namespace {

bool has_height(const Edict& player, const math::Vec3& maxs) {
  return player[field::kMins] == movement::kPlayerMins && player[field::kMaxs] == maxs;
}

bool can_stand_up(GameWorld& io_world, const Edict& player) {
  const math::Vec3 origin = player[field::kOrigin];
  return !trace_move(io_world, origin, movement::kPlayerMins, movement::kPlayerMaxs, origin,
                     MoveKind::kNormal, player.index())
              .trace.start_solid;
}

void set_height(const Edict& player, const math::Vec3& maxs) {
  player.set(field::kMaxs, maxs);
  player.set(field::kSize, maxs - movement::kPlayerMins);
}

void set_eyes(const Edict& player, float height) {
  math::Vec3 eyes = player[field::kViewOffset];
  eyes.z = height;
  player.set(field::kViewOffset, eyes);
}

}  // namespace

bool is_crouching(const GameWorld& world, const Edict& player) {
  return world.level->is_half_life && has_height(player, movement::kCrouchedMaxs);
}

// The eyes are lowered smoothly.
float find_crouched_drop(const GameWorld& world, const Edict& player) {
  const float eyes_z = math::Vec3(player[field::kViewOffset]).z;
  const bool is_lowered = world.level->is_half_life && player.move_type() == MoveType::kWalk &&
                          player[field::kHealth] > 0 && movement::is_crouching_height(eyes_z);
  return is_lowered ? movement::kStandingEyes - eyes_z : 0;
}

void crouch(GameWorld& io_world, vm::EntityIndex player, float wish_up) {
  if (!io_world.level->is_half_life) return;
  const Edict edict = io_world.edicts[player];
  if (edict.move_type() != MoveType::kWalk || edict[field::kHealth] <= 0) return;
  if (!is_crouching(io_world, edict) && !has_height(edict, movement::kPlayerMaxs)) return;
  const bool is_low = movement::is_crouching_next(make_player(io_world, edict), wish_up,
                                                  [&] { return can_stand_up(io_world, edict); });
  set_height(edict, is_low ? movement::kCrouchedMaxs : movement::kPlayerMaxs);
  set_eyes(edict,
           movement::move_eyes(math::Vec3(edict[field::kViewOffset]).z, is_low, tick_seconds(io_world)));
}

}  // namespace temblor::server
