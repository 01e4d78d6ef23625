// Traces: how far a box gets through the level and everything solid in it. Physics, QuakeC and bots all use
// this.
// The level and brush models are traced through their clip hulls (world/trace.h), all other entities as
// axis-aligned boxes. The areas (game/areas.h) limit the search to entities near the path.
#pragma once

#include "server/game/game_world.h"
#include "world/trace.h"

namespace temblor::server {

enum class MoveKind {
  kNormal,
  kNoMonsters,  // only brush models stop it
  kMissile,     // hits monsters with a box of +-15 units
};

struct EntityTrace {
  world::Trace trace;
  vm::EntityIndex entity = vm::kWorld;  // what stopped it, or what it starts in; valid if `hit`
  bool hit = false;                     // trace.fraction < 1, or it starts in solid
};

// Moves a box from `start` to `end`. It passes through the entity `passing`, its owner, and what it owns.
// (For the world as `passing`, that is everything without an owner, as in the original.) A box with a width
// passes through entities without one. A brush model is traced with the hull that fits the box's size; other
// solids are boxes.
//
// The plane's distance is the hull's, not moved by the model's origin or the box, as in stock Quake. Unlike
// there, a path that starts inside an entity and leaves it stops at the next obstacle; the original let it
// through everything.
EntityTrace trace_move(GameWorld& io_world, const math::Vec3& start, const math::Vec3& mins,
                       const math::Vec3& maxs, const math::Vec3& end, MoveKind kind, vm::EntityIndex passing);
// The level's contents at a point. Currents count as water; entities do not count.
world::Contents point_contents(const GameWorld& world, const math::Vec3& point);
// Whether an entity's box is in something solid.
bool is_stuck(GameWorld& io_world, vm::EntityIndex entity);

// Traces a point against a box. It stops 1/32 unit before the side that it hits. Lower sides belong to the
// box, upper ones do not. A box without volume stops nothing.
world::Trace trace_box(const math::Bounds& box, const math::Vec3& start, const math::Vec3& end);

}  // namespace temblor::server
