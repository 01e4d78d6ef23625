#include "server/physics/entity_moves.h"

#include <algorithm>
#include <cmath>

#include "movement/player.h"

namespace temblor::server {
namespace {

constexpr std::string_view kSplash = "misc/h2ohit1.wav";

// Calls the touch functions of both, the mover's first. Each is skipped if its entity is not solid by then.
base::Status impact(GameWorld& io_world, vm::EntityIndex mover, vm::EntityIndex met) {
  const auto touch = [&](vm::EntityIndex self, vm::EntityIndex other) -> base::Status {
    const Edict edict = io_world.edicts[self];
    if (edict[field::kTouch] == vm::kNoFunction || edict.solid() == Solid::kNot) return base::Ok{};
    return io_world.calls.call(edict[field::kTouch], self, other, io_world.time_s);
  };
  TRY_STATUS(touch(mover, met));
  return touch(met, mover);
}

}  // namespace

movement::Body make_body(const Edict& edict) {
  return {edict[field::kOrigin], edict[field::kVelocity], edict.has_flag(flag::kOnGround),
          static_cast<std::uint32_t>(edict[field::kGroundEntity])};
}

void EntityEnvironment::store(const movement::Body& body) {
  const Edict self = edict();
  self.set(field::kOrigin, body.origin);
  self.set(field::kVelocity, body.velocity);
  self.set(field::kGroundEntity, vm::EntityIndex{body.ground});
  if (body.on_ground)
    self.set_flag(flag::kOnGround);
  else
    self.clear_flag(flag::kOnGround);
}

movement::Contact EntityEnvironment::find_contact(const math::Vec3& start, const math::Vec3& end,
                                                  MoveKind kind) const {
  const Edict self = edict();
  const EntityTrace found =
      trace_move(world_, start, self[field::kMins], self[field::kMaxs], end, kind, entity_);
  return {found.trace, static_cast<std::uint32_t>(found.entity), found.hit,
          world_.edicts[found.entity].solid() == Solid::kBsp};
}

movement::Contact EntityEnvironment::trace(const math::Vec3& start, const math::Vec3& end) {
  return find_contact(start, end, MoveKind::kNormal);
}

movement::Contact EntityEnvironment::trace_push(const math::Vec3& start, const math::Vec3& end) {
  const Edict self = edict();
  if (self.move_type() == MoveType::kFlyMissile) return find_contact(start, end, MoveKind::kMissile);
  // An entity that stops nobody is itself stopped only by brush models.
  const bool is_thin = self.solid() == Solid::kTrigger || self.solid() == Solid::kNot;
  return find_contact(start, end, is_thin ? MoveKind::kNoMonsters : MoveKind::kNormal);
}

base::Result<bool> EntityEnvironment::touch(const movement::Contact& contact, movement::Body& io_body) {
  store(io_body);
  TRY_STATUS(impact(world_, entity_, vm::EntityIndex{contact.obstacle}));
  if (!is_there(world_, entity_)) return false;
  io_body = body();
  return true;
}

base::Result<bool> EntityEnvironment::moved(movement::Body& io_body) {
  store(io_body);
  TRY_STATUS(link(world_, entity_, TouchTriggers::kYes));
  if (!is_there(world_, entity_)) return false;
  io_body = body();
  return true;
}

// Only players climb stairs, and only from the ground or out of water: nobody climbs while it jumps.
bool EntityEnvironment::may_climb(bool was_on_ground) {
  const Edict self = edict();
  if (!was_on_ground && self[field::kWaterLevel] == 0) return false;
  return self.move_type() == MoveType::kWalk && !world_.settings.no_step && !self.has_flag(flag::kWaterJump);
}

base::Result<movement::Push> push_entity(GameWorld& io_world, vm::EntityIndex entity, const math::Vec3& way) {
  EntityEnvironment environment(io_world, entity);
  movement::Body body = environment.body();
  return movement::push(body, way, environment);
}

// QuakeC sees its due time, not the start of the tick, so that a chain of thinks at 0.1 s does not drift. A
// time that has passed already counts as now.
base::Result<bool> run_think(GameWorld& io_world, vm::EntityIndex entity) {
  const Edict edict = io_world.edicts[entity];
  const double think_s = edict[field::kNextThink];
  if (!(think_s > 0) || think_s > io_world.time_s + io_world.tick_s) return true;
  edict.set(field::kNextThink, 0);
  TRY_STATUS(
      io_world.calls.call(edict[field::kThink], entity, vm::kWorld, std::max(think_s, io_world.time_s)));
  return is_there(io_world, entity);
}

void check_velocity(GameWorld& io_world, vm::EntityIndex entity) {
  const Edict edict = io_world.edicts[entity];
  math::Vec3 origin = edict[field::kOrigin];
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(origin[axis])) origin[axis] = 0;
  edict.set(field::kVelocity,
            movement::limit_velocity(edict[field::kVelocity], io_world.settings.max_velocity));
  edict.set(field::kOrigin, origin);
}

// A `gravity` of 0 stands for 1, because fields start at 0.
void add_gravity(GameWorld& io_world, vm::EntityIndex entity) {
  const Edict edict = io_world.edicts[entity];
  const float own = io_world.gravity_field ? edict[*io_world.gravity_field] : 1;
  math::Vec3 velocity = edict[field::kVelocity];
  velocity.z -= (own != 0 ? own : 1) * io_world.settings.gravity * tick_seconds(io_world);
  edict.set(field::kVelocity, velocity);
}

bool check_water(GameWorld& io_world, vm::EntityIndex player) {
  const Edict edict = io_world.edicts[player];
  const movement::PlayerHeights heights{edict[field::kMins].z, edict[field::kMaxs].z,
                                        edict[field::kViewOffset].z};
  const movement::Water water =
      movement::find_water(edict[field::kOrigin], heights,
                           [&](const math::Vec3& point) { return point_contents(io_world, point); });
  edict.set(field::kWaterType, static_cast<float>(water.at_feet));
  edict.set(field::kWaterLevel, static_cast<float>(water.level));
  return water.level >= movement::kSwimmingLevel;
}

// While the entity is in the air, waterlevel holds the contents, a negative number, as in stock Quake.
void check_water_transition(GameWorld& io_world, vm::EntityIndex entity) {
  const Edict edict = io_world.edicts[entity];
  const world::Contents contents = point_contents(io_world, edict[field::kOrigin]);
  const auto here = static_cast<float>(contents);
  if (edict[field::kWaterType] == 0) {  // a new entity: it makes no splash
    edict.set(field::kWaterType, here);
    edict.set(field::kWaterLevel, 1);
    return;
  }
  const bool was_in_air = edict[field::kWaterType] == static_cast<float>(world::Contents::kEmpty);
  if (movement::is_liquid(contents) == was_in_air) io_world.sounds.push_back({entity, kSplash});
  const bool is_in = movement::is_liquid(contents);
  edict.set(field::kWaterType, is_in ? here : static_cast<float>(world::Contents::kEmpty));
  edict.set(field::kWaterLevel, is_in ? 1.0f : here);
}

}  // namespace temblor::server
