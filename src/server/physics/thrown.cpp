// Entities that fly or fall on their own: missiles, grenades, gibs, items, and monsters in the air. Also
// those that only think, pass through walls, or follow another entity.
#include "math/angles.h"
#include "server/physics/entity_moves.h"
#include "server/physics/moves.h"

namespace temblor::server {
namespace {

// For clip_velocity(): 1 would stop at the surface, 2 would keep all of the speed.
constexpr float kBounce = 1.5f;
// Units per second. A bounce that rises more slowly than this comes to rest.
constexpr float kRestSpeed = 60;
// A monster that falls faster than this part of gravity lands with a sound.
constexpr float kHardLanding = -0.1f;
constexpr std::string_view kLanding = "demon/dland2.wav";

bool is_weightless(MoveType type) {
  return type == MoveType::kFly || type == MoveType::kFlyMissile;
}

void turn(const Edict& edict, float tick_s) {
  edict.set(field::kAngles, edict[field::kAngles] + edict[field::kAngularVelocity] * tick_s);
}

// Only a floor ends a flight: the entity then lies on it, at rest.
void bounce(const Edict& edict, const movement::Contact& contact) {
  const bool bounces = edict.move_type() == MoveType::kBounce;
  const math::Vec3 normal = contact.trace.plane_normal;
  const math::Vec3 velocity = movement::clip_velocity(edict[field::kVelocity], normal, bounces ? kBounce : 1);
  edict.set(field::kVelocity, velocity);
  if (normal.z <= movement::kFloorNormal || (bounces && velocity.z >= kRestSpeed)) return;
  edict.set_flag(flag::kOnGround);
  edict.set(field::kGroundEntity, vm::EntityIndex{contact.obstacle});
  edict.set(field::kVelocity, math::Vec3(0.0f));
  edict.set(field::kAngularVelocity, math::Vec3(0.0f));
}

}  // namespace

// An entity at rest only thinks, until something clears its kOnGround flag.
base::Status run_thrown(GameWorld& io_world, vm::EntityIndex entity) {
  TRY(const bool is_left, run_think(io_world, entity));
  if (!is_left) return base::Ok{};
  if (io_world.edicts[entity].has_flag(flag::kOnGround)) return base::Ok{};
  check_velocity(io_world, entity);
  if (!is_weightless(io_world.edicts[entity].move_type())) add_gravity(io_world, entity);
  turn(io_world.edicts[entity], tick_seconds(io_world));
  const math::Vec3 way = io_world.edicts[entity][field::kVelocity] * tick_seconds(io_world);
  TRY(const movement::Push push, push_entity(io_world, entity, way));
  // An entity splashes only in a tick in which it meets something, as in stock Quake.
  if (push.is_gone || push.contact.trace.fraction == 1) return base::Ok{};
  bounce(io_world.edicts[entity], push.contact);
  check_water_transition(io_world, entity);
  return base::Ok{};
}

// A monster falls like a player, without climbing steps. On the ground it moves only by its think function,
// in single steps, which is why monsters jerk in stock clients.
base::Status run_monster(GameWorld& io_world, vm::EntityIndex entity) {
  if (!io_world.edicts[entity].has_flag(flag::kOnGround | flag::kFly | flag::kSwim)) {
    const bool falls_hard =
        io_world.edicts[entity][field::kVelocity].z < kHardLanding * io_world.settings.gravity;
    add_gravity(io_world, entity);
    check_velocity(io_world, entity);
    EntityEnvironment environment(io_world, entity);
    movement::Body body = environment.body();
    TRY(const movement::Slide slide, movement::slide(body, tick_seconds(io_world), environment));
    if (slide.is_gone) return base::Ok{};
    TRY(const bool is_left, environment.moved(body));
    if (!is_left) return base::Ok{};
    if (body.on_ground && falls_hard) io_world.sounds.push_back({entity, kLanding});
  }
  TRY(const bool is_left, run_think(io_world, entity));
  if (is_left) check_water_transition(io_world, entity);
  return base::Ok{};
}

base::Status run_still(GameWorld& io_world, vm::EntityIndex entity) {
  TRY_STATUS(run_think(io_world, entity));
  return base::Ok{};
}

// kNoClip: moves without looking.
base::Status run_ghost(GameWorld& io_world, vm::EntityIndex entity) {
  TRY(const bool is_left, run_think(io_world, entity));
  if (!is_left) return base::Ok{};
  const Edict edict = io_world.edicts[entity];
  turn(edict, tick_seconds(io_world));
  edict.set(field::kOrigin, edict[field::kOrigin] + edict[field::kVelocity] * tick_seconds(io_world));
  return link(io_world, entity, TouchTriggers::kNo);
}

// Fields as mods use them: aiment is the entity to follow, view_ofs the offset from it (as it was when that
// entity's angles were punchangle), and v_angle the rotation relative to it.
base::Status run_follower(GameWorld& io_world, vm::EntityIndex entity) {
  TRY(const bool is_left, run_think(io_world, entity));
  if (!is_left) return base::Ok{};
  const Edict edict = io_world.edicts[entity];
  const Edict followed = io_world.edicts.at(edict[field::kAimEntity]);
  const math::Vec3 angles = followed[field::kAngles];
  math::Vec3 offset = edict[field::kViewOffset];
  if (angles != edict[field::kPunchAngle]) {
    const math::Basis before = math::basis_from_angles(edict[field::kPunchAngle]);
    const math::Basis now = math::basis_from_angles(angles);
    const math::Vec3d wide(offset);
    offset = math::Vec3(now.forward * glm::dot(wide, before.forward) +
                        now.right * glm::dot(wide, before.right) + now.up * glm::dot(wide, before.up));
  }
  edict.set(field::kOrigin, followed[field::kOrigin] + offset);
  edict.set(field::kAngles, angles + edict[field::kViewAngles]);
  return link(io_world, entity, TouchTriggers::kYes);
}

}  // namespace temblor::server
