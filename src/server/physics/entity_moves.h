// What all ways of moving share: an entity as a body among others, its thinking, its water.
#pragma once

#include "movement/walk.h"
#include "server/game_world.h"
#include "server/move_trace.h"

namespace temblor::server {

movement::Body body_of(const Edict& edict);

// An entity and what it moves among: what it touches is told to the program, which may do anything with it.
class EntityEnvironment : public movement::WalkEnvironment {
 public:
  EntityEnvironment(GameWorld& io_world, vm::EntityIndex entity) : world_(io_world), entity_(entity) {}

  movement::Body body() const { return body_of(edict()); }
  void store(const movement::Body& body);

  movement::Contact trace(const math::Vec3& start, const math::Vec3& end) override;
  movement::Contact trace_push(const math::Vec3& start, const math::Vec3& end) override;
  base::Result<bool> touch(const movement::Contact& contact, movement::Body& io_body) override;
  base::Result<bool> moved(movement::Body& io_body) override;
  bool may_climb(bool was_on_ground) override;

 private:
  Edict edict() const { return world_.edicts[entity_]; }
  movement::Contact contact_of(const math::Vec3& start, const math::Vec3& end, MoveKind kind) const;

  GameWorld& world_;
  vm::EntityIndex entity_;
};

// Moves an entity as far as it gets, links it there, and lets it and what it met touch each other.
base::Result<movement::Push> push_entity(GameWorld& io_world, vm::EntityIndex entity, const math::Vec3& way);

// Calls think if its time comes before the tick's end. false: the entity is gone.
base::Result<bool> run_think(GameWorld& io_world, vm::EntityIndex entity);

// Makes numbers of an origin and a velocity that are none, and bounds the velocity.
void check_velocity(GameWorld& io_world, vm::EntityIndex entity);
// A tick's gravity, all of it before the move.
void add_gravity(GameWorld& io_world, vm::EntityIndex entity);
// Sets a player's waterlevel (1 feet, 2 middle, 3 eyes) and watertype; true: it swims.
bool check_water(GameWorld& io_world, vm::EntityIndex player);
// Of what falls: a splash on the way in and out.
void check_water_transition(GameWorld& io_world, vm::EntityIndex entity);

inline float tick_of(const GameWorld& world) {
  return static_cast<float>(world.tick_s);
}

}  // namespace temblor::server
