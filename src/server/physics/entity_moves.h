// Common parts of all move types: an entity as a body that meets others, its think function, gravity, and
// water.
#pragma once

#include "movement/walk.h"
#include "server/game/game_world.h"
#include "server/move_trace.h"

namespace temblor::server {

movement::Body make_body(const Edict& edict);

// An entity and everything that it moves among. Its touches are reported to QuakeC, whose touch functions
// may change or remove any entity, including this one. So the body is stored in the entity before each such
// call, and read again after it.
class EntityEnvironment : public movement::WalkEnvironment {
 public:
  EntityEnvironment(GameWorld& io_world, vm::EntityIndex entity) : world_(io_world), entity_(entity) {}

  movement::Body body() const { return make_body(edict()); }
  void store(const movement::Body& body);

  movement::Contact trace(const math::Vec3& start, const math::Vec3& end) override;
  movement::Contact trace_push(const math::Vec3& start, const math::Vec3& end) override;
  base::Result<bool> touch(const movement::Contact& contact, movement::Body& io_body) override;
  base::Result<bool> moved(movement::Body& io_body) override;
  bool may_climb(bool was_on_ground) override;

 private:
  Edict edict() const { return world_.edicts[entity_]; }
  movement::Contact find_contact(const math::Vec3& start, const math::Vec3& end, MoveKind kind) const;

  GameWorld& world_;
  vm::EntityIndex entity_;
};

// Moves an entity in a straight line as far as it gets, links it there, and calls the touch functions of it
// and of what it met.
base::Result<movement::Push> push_entity(GameWorld& io_world, vm::EntityIndex entity, const math::Vec3& way);

// Calls `think` if its time comes before the end of this tick. false: the entity was removed.
base::Result<bool> run_think(GameWorld& io_world, vm::EntityIndex entity);

// Replaces NaN and infinities in an entity's origin and velocity by 0, and limits the velocity.
void check_velocity(GameWorld& io_world, vm::EntityIndex entity);
// Adds a tick's gravity to the velocity, all of it before the move.
void add_gravity(GameWorld& io_world, vm::EntityIndex entity);
// Sets a player's waterlevel (1 feet, 2 waist, 3 eyes) and watertype. true: the player swims.
bool check_water(GameWorld& io_world, vm::EntityIndex player);
// For entities that fall: plays a splash on the way in and out, and sets watertype and waterlevel.
void check_water_transition(GameWorld& io_world, vm::EntityIndex entity);

// The length of this tick in seconds, in the precision in which the original computes moves.
inline float tick_seconds(const GameWorld& world) {
  return static_cast<float>(world.tick_s);
}

}  // namespace temblor::server
