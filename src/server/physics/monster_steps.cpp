// Single steps of monsters: whether a monster can stand where a step leads, and turning.
//    step_on_floor():   above +         1. from a step's height above the new place
//                             |         2. down by two step heights
//      monster --> [ ]        v         3. floor found: all four corners of the box must have floor, too
//      ______________|____ below +
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "movement/walk.h"
#include "server/move_trace.h"
#include "server/physics/monster_angles.h"
#include "server/physics/physics.h"

namespace temblor::server {
namespace {

constexpr float kStep = movement::kStepHeight;
// Units. Fliers keep between these heights above their enemy, and rise or sink by the last one in each step.
constexpr float kTooHigh = 40, kTooLow = 30, kHeightStep = 8;

EntityTrace trace_monster(GameWorld& io_world, const Edict& monster, const math::Vec3& start,
                          const math::Vec3& end) {
  return trace_move(io_world, start, monster[field::kMins], monster[field::kMaxs], end, MoveKind::kNormal,
                    monster.index());
}

base::Result<bool> move_to(GameWorld& io_world, const Edict& monster, const math::Vec3& place,
                           TouchTriggers touch) {
  monster.set(field::kOrigin, place);
  if (touch == TouchTriggers::kYes) TRY_STATUS(link(io_world, monster.index(), touch));
  return true;
}

// Tries a step that also comes nearer to the enemy's height, then a level one. A swimmer never leaves the
// water.
base::Result<bool> step_through_space(GameWorld& io_world, const Edict& monster, const math::Vec3& step,
                                      TouchTriggers touch) {
  const math::Vec3 origin = monster[field::kOrigin];
  const Edict enemy = io_world.edicts.at(monster[field::kEnemy]);
  const bool has_enemy = enemy.index() != vm::kWorld;
  for (int attempt = has_enemy ? 0 : 1; attempt < 2; ++attempt) {
    math::Vec3 place = origin + step;
    if (attempt == 0) {
      const float above = origin.z - enemy[field::kOrigin].z;
      if (above > kTooHigh) place.z -= kHeightStep;
      if (above < kTooLow) place.z += kHeightStep;
    }
    const EntityTrace way = trace_monster(io_world, monster, origin, place);
    if (way.trace.fraction < 1) continue;
    const bool leaves_water =
        monster.has_flag(flag::kSwim) && point_contents(io_world, way.trace.end) == world::Contents::kEmpty;
    if (leaves_water) return false;
    return move_to(io_world, monster, way.trace.end, touch);
  }
  return false;
}

// A monster never walks over an edge, unless it hangs over one already (kPartialGround): else it would stand
// there for good.
base::Result<bool> step_on_floor(GameWorld& io_world, const Edict& monster, const math::Vec3& step,
                                 TouchTriggers touch) {
  const math::Vec3 origin = monster[field::kOrigin];
  math::Vec3 above = origin + step + math::Vec3(0, 0, kStep);
  const math::Vec3 below = above - math::Vec3(0, 0, 2 * kStep);
  EntityTrace down = trace_monster(io_world, monster, above, below);
  if (down.trace.all_solid) return false;
  if (down.trace.start_solid) {
    above.z -= kStep;
    down = trace_monster(io_world, monster, above, below);
    if (down.trace.start_solid) return false;
  }
  // A monster that hangs over an edge already may move on over it.
  const bool hangs = monster.has_flag(flag::kPartialGround);
  if (down.trace.fraction == 1) {
    if (!hangs) return false;
    monster.clear_flag(flag::kOnGround);
    return move_to(io_world, monster, origin + step, touch);
  }
  monster.set(field::kOrigin, down.trace.end);
  if (!check_bottom(io_world, monster.index())) {
    if (hangs) return move_to(io_world, monster, down.trace.end, touch);
    monster.set(field::kOrigin, origin);
    return false;
  }
  monster.clear_flag(flag::kPartialGround);
  monster.set(field::kGroundEntity, down.entity);
  return move_to(io_world, monster, down.trace.end, touch);
}

// The first and the last are opposite corners.
std::array<math::Vec3, 4> bottom_corners(const Edict& edict) {
  const math::Vec3 mins = edict[field::kOrigin] + edict[field::kMins];
  const math::Vec3 maxs = edict[field::kOrigin] + edict[field::kMaxs];
  return {{mins, {mins.x, maxs.y, mins.z}, {maxs.x, mins.y, mins.z}, {maxs.x, maxs.y, mins.z}}};
}

}  // namespace

base::Result<bool> step_monster(GameWorld& io_world, vm::EntityIndex monster, const math::Vec3& step,
                                TouchTriggers touch) {
  const Edict edict = io_world.edicts[monster];
  return edict.has_flag(flag::kSwim | flag::kFly) ? step_through_space(io_world, edict, step, touch)
                                                  : step_on_floor(io_world, edict, step, touch);
}

bool can_step(const Edict& monster) {
  return monster.has_flag(flag::kOnGround | flag::kFly | flag::kSwim);
}

math::Vec3 step_towards(float yaw_deg, float distance) {
  const double yaw = double{yaw_deg} * (std::numbers::pi / 180);
  return math::Vec3(math::Vec3d(std::cos(yaw), std::sin(yaw), 0) * double{distance});
}

base::Result<bool> walk_move(GameWorld& io_world, vm::EntityIndex monster, float yaw_deg, float distance) {
  if (!can_step(io_world.edicts[monster])) return false;
  return step_monster(io_world, monster, step_towards(yaw_deg, distance), TouchTriggers::kYes);
}

// Two tests, as in the original: a cheap one that succeeds on the level's own floor, then traces for the rest
// (brush models, stairs, slopes).
bool check_bottom(GameWorld& io_world, vm::EntityIndex monster) {
  const Edict edict = io_world.edicts[monster];
  const auto corners = bottom_corners(edict);
  // In most cases all four are on the level's floor.
  bool is_on_level = true;
  for (const math::Vec3& corner : corners)
    is_on_level =
        is_on_level && point_contents(io_world, corner - math::Vec3(0, 0, 1)) == world::Contents::kSolid;
  if (is_on_level) return true;

  const auto down_from = [&](const math::Vec3& start) {
    constexpr math::Vec3 kPoint(0.0f);
    return trace_move(io_world, start, kPoint, kPoint, start - math::Vec3(0, 0, 2 * kStep),
                      MoveKind::kNoMonsters, monster)
        .trace;
  };
  const world::Trace middle = down_from((corners[0] + corners[3]) * 0.5f);
  if (middle.fraction == 1) return false;
  for (const math::Vec3& corner : corners) {
    const world::Trace down = down_from(corner);
    if (down.fraction == 1 || middle.end.z - down.end.z > kStep) return false;
  }
  return true;
}

float whole_turn_deg(float angle_deg) {
  constexpr double kParts = 65536;
  const double parts = std::fmod(std::trunc(double{angle_deg} * kParts / 360), kParts);
  // NaN and infinities.
  if (!std::isfinite(parts)) return 0;
  return static_cast<float>((parts < 0 ? parts + kParts : parts) * 360 / kParts);
}

void change_yaw(GameWorld& io_world, vm::EntityIndex monster) {
  const Edict edict = io_world.edicts[monster];
  math::Vec3 angles = edict[field::kAngles];
  const float current = whole_turn_deg(angles.y);
  const float ideal = edict[field::kIdealYaw], speed = edict[field::kYawSpeed];
  if (current == ideal) return;
  float turn = ideal - current;
  if (turn >= 180) turn -= 360;
  if (turn <= -180) turn += 360;
  turn = turn > 0 ? std::min(turn, speed) : std::max(turn, -speed);
  angles.y = whole_turn_deg(current + turn);
  edict.set(field::kAngles, angles);
}

// Unlike a fall, this needs no ticks: items do it when the level starts.
base::Result<bool> drop_to_floor(GameWorld& io_world, vm::EntityIndex entity) {
  constexpr float kDepth = 256;
  const Edict edict = io_world.edicts[entity];
  const math::Vec3 origin = edict[field::kOrigin];
  const EntityTrace down = trace_monster(io_world, edict, origin, origin - math::Vec3(0, 0, kDepth));
  if (down.trace.fraction == 1 || down.trace.all_solid) return false;
  edict.set(field::kOrigin, down.trace.end);
  TRY_STATUS(link(io_world, entity, TouchTriggers::kNo));
  edict.set_flag(flag::kOnGround);
  edict.set(field::kGroundEntity, down.entity);
  return true;
}

}  // namespace temblor::server
