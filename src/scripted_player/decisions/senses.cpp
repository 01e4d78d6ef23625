#include "scripted_player/decisions/senses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "movement/player.h"
#include "movement/walk.h"
#include "server/move_trace.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kStep_units = 16;
constexpr float kDegrees = 180 / std::numbers::pi_v<float>;

server::EntityTrace trace(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
                          const math::Vec3& to) {
  return server::trace_move(io_world, from, movement::kPlayerMins, movement::kPlayerMaxs, to,
                            server::MoveKind::kNoMonsters, player);
}

// Returns whether a player with that origin stands in lava or slime.
bool is_in_lava_or_slime(server::GameWorld& io_world, const math::Vec3& origin) {
  const world::Contents feet =
      server::point_contents(io_world, origin + math::Vec3(0, 0, movement::kPlayerMins.z + 1));
  return feet == world::Contents::kLava || feet == world::Contents::kSlime;
}

// Moves `io_at` by one step to `to`, up or down stairs. Returns false if that is not possible.
// Tries the straight line first, then a step up, as movement/walk.h does; then puts the player down on the
// floor.
bool step(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& to, math::Vec3& io_at) {
  math::Vec3 over = to;
  const auto across = trace(io_world, player, io_at, to);
  if (across.trace.start_solid) return false;
  if (across.trace.fraction < 1) {
    const auto up = trace(io_world, player, io_at, io_at + math::Vec3(0, 0, movement::kStepHeight));
    const auto on = trace(io_world, player, up.trace.end, {to.x, to.y, up.trace.end.z});
    if (on.trace.fraction < 1) return false;
    over = on.trace.end;
  }
  const auto down = trace(io_world, player, over, {over.x, over.y, io_at.z - movement::kStepHeight - 0.1f});
  if (down.trace.fraction == 1 || down.trace.plane_normal.z < movement::kFloorNormal) return false;
  io_at = down.trace.end;
  return !is_in_lava_or_slime(io_world, io_at);
}

}  // namespace

Self read_self(server::Game& io_game, std::size_t slot) {
  const server::Edict edict = io_game.player(slot);
  Self self;
  self.entity = edict.index();
  self.origin = edict[field::kOrigin];
  self.velocity = edict[field::kVelocity];
  self.on_ground = edict.has_flag(server::flag::kOnGround);
  self.ground = edict[field::kGroundEntity];
  self.water_level = edict.whole(field::kWaterLevel);
  self.health = edict[field::kHealth];
  self.armor = edict[field::kArmorValue];
  self.items = edict.whole(field::kItems);
  self.weapon = edict.whole(field::kWeapon);
  self.shells = edict[field::kAmmoShells];
  self.nails = edict[field::kAmmoNails];
  self.rockets = edict[field::kAmmoRockets];
  self.cells = edict[field::kAmmoCells];
  return self;
}

// Follows the floor in steps of 16 units. The end may be up to two steps higher or lower than `to`, which is
// often just above the floor.
bool can_walk(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
              const math::Vec3& to) {
  const math::Vec3 offset(to.x - from.x, to.y - from.y, 0);
  const float length = glm::length(offset);
  math::Vec3 at = from;
  for (float done = 0; done < length;) {
    done = std::min(done + kStep_units, length);
    const math::Vec3 next = from + offset * (done / length);
    if (!step(io_world, player, {next.x, next.y, at.z}, at)) return false;
  }
  return std::abs(at.z - to.z) < 2 * movement::kStepHeight;
}

bool can_swim(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
              const math::Vec3& to) {
  return trace(io_world, player, from, to).trace.fraction == 1;
}

// Walks in a straight line as far as possible, then falls.
bool leads_into_lava(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
                     const math::Vec3& to) {
  constexpr float kDeepest_units = 4096;
  const math::Vec3 over = trace(io_world, player, from, to).trace.end;
  return is_in_lava_or_slime(
      io_world, trace(io_world, player, over, over - math::Vec3(0, 0, kDeepest_units)).trace.end);
}

bool can_see(server::GameWorld& io_world, vm::EntityIndex player, const math::Vec3& from,
             const math::Vec3& to) {
  return server::trace_move(io_world, from, {0, 0, 0}, {0, 0, 0}, to, server::MoveKind::kNoMonsters, player)
             .trace.fraction == 1;
}

math::Vec3 angles_toward(const math::Vec3& from, const math::Vec3& to) {
  const math::Vec3 offset = to - from;
  const float level = glm::length(math::Vec2(offset));
  return {-std::atan2(offset.z, level) * kDegrees, std::atan2(offset.y, offset.x) * kDegrees, 0};
}

float angle_difference_deg(float from_deg, float to_deg) {
  return std::remainder(to_deg - from_deg, 360.0f);
}

}  // namespace temblor::player
