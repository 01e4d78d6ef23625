// How far a box gets through the level and everything solid in it.
#pragma once

#include "server/game_world.h"
#include "world/trace.h"

namespace temblor::server {

enum class MoveKind {
  kNormal,
  kNoMonsters,  // only brush models stop it
  kMissile,     // meets monsters with a box of +-15 units
};

struct EntityTrace {
  world::Trace trace;
  vm::EntityIndex entity = vm::kWorld;  // what stopped it, or what it starts in; only where `hit`
  bool hit = false;                     // trace.fraction < 1, or it starts in solid
};

// `passing`: does not meet itself, nor its owner, nor what it owns (for the world as `passing` that is
// everything without an owner, as in the original). A box with a width does not meet entities without one.
// Brush models are asked by the hull that fits the size; a solid brush that has no brush model is its box.
// The plane's distance is the hull's, as in the original: not moved along with the model or the box.
// A path that starts within an entity and leaves it again ends where the next thing stops it; the original
// let it pass through everything then.
EntityTrace trace_move(GameWorld& io_world, const math::Vec3& start, const math::Vec3& mins,
                       const math::Vec3& maxs, const math::Vec3& end, MoveKind kind, vm::EntityIndex passing);
// Contents at a point: of the world only, currents counted as water.
world::Contents point_contents(const GameWorld& world, const math::Vec3& point);
// Whether an entity's box lies in something solid where it is.
bool is_stuck(GameWorld& io_world, vm::EntityIndex entity);

// A point against a box: stops 1/32 unit before the side that it meets. Lower sides belong to the box, upper
// ones do not; a box without volume, or upside down, stops nothing.
world::Trace trace_box(const math::Bounds& box, const math::Vec3& start, const math::Vec3& end);

}  // namespace temblor::server
