// Method: the box is traced through the level first. Then, as far as it got, it is traced through the
// entities whose boxes touch its path: each one as a brush model's hull, or as its box expanded by the
// mover's box (the Minkowski sum), so that the mover becomes a point. The nearest obstacle counts; of equally
// near ones, the first in the order of the areas.
#include "server/move_trace.h"

#include <algorithm>
#include <cmath>

#include "world/visibility.h"

namespace temblor::server {
namespace {

// Units that a trace keeps from a surface, as in clip hulls. Without it, rounding could end a move inside.
constexpr double kSurfaceGap = 1.0 / 32;
constexpr math::Bounds kMissileBox{{-15, -15, -15}, {15, 15, 15}};
// Includes entities whose boxes only touch the path.
constexpr float kReach = 1;

// One call of trace_move(), with everything that does not depend on the obstacle.
struct Mover {
  math::Vec3 start, end;
  math::Bounds box, box_for_monsters;
  MoveKind kind;
  vm::EntityIndex passing;
  vm::EntityIndex owner;  // of `passing`
  bool has_width;         // of `passing`, as its size says
};

world::Trace trace_model(const world::Level& level, world::ModelIndex model, const math::Vec3& origin,
                         const Mover& mover) {
  return world::trace_box_through_model(level, model, origin, mover.box, mover.start, mover.end);
}

// Invariant: Solid::kBsp without a brush model (game code may set it on any entity) is traced as a box. The
// original ended the game there.
world::Trace trace_entity(const GameWorld& world, const Edict& edict, const Mover& mover) {
  const math::Vec3 origin = edict[field::kOrigin];
  if (edict.solid() == Solid::kBsp)
    if (const ServerModel* model = world.find_model(edict); model != nullptr && model->brush_model)
      return trace_model(*world.level, *model->brush_model, origin, mover);
  const math::Bounds& box = edict.has_flag(flag::kMonster) ? mover.box_for_monsters : mover.box;
  return trace_box({origin + edict[field::kMins] - box.maxs, origin + edict[field::kMaxs] - box.mins},
                   mover.start, mover.end);
}

// The filters of MoveKind and ownership, as the original has them. `owner` works both ways: a missile passes
// through the player who fired it, and the player through the missile.
bool can_collide(const Mover& mover, const Edict& edict) {
  if (edict.index() == mover.passing || edict.solid() == Solid::kNot) return false;
  if (mover.kind == MoveKind::kNoMonsters && edict.solid() != Solid::kBsp) return false;
  if (mover.has_width && edict[field::kSize].x == 0) return false;
  return edict[field::kOwner] != mover.passing && mover.owner != edict.index();
}

// The box that contains the whole path from start to end.
math::Bounds swept_box(const Mover& mover, const math::Vec3& end) {
  const math::Bounds& box = mover.box_for_monsters;
  return {glm::min(mover.start, end) + glm::min(box.mins, mover.box.mins) - kReach,
          glm::max(mover.start, end) + glm::max(box.maxs, mover.box.maxs) + kReach};
}

// Keeps the nearer of two results. start_solid is kept from any of them: it says that the start is in
// something, even if something else stopped the box.
void keep_nearer(const world::Trace& trace, vm::EntityIndex entity, EntityTrace& io_nearest) {
  const bool started_solid = io_nearest.trace.start_solid || trace.start_solid;
  if (trace.all_solid || trace.fraction < io_nearest.trace.fraction ||
      (trace.start_solid && io_nearest.trace.fraction == 1)) {
    io_nearest.trace = trace;
    io_nearest.entity = entity;
    io_nearest.hit = true;
  }
  io_nearest.trace.start_solid = started_solid;
}

// The part of a path during which a point is between two sides: from `enter` (-1: it starts there) to
// `leave`, as fractions of the path.
constexpr double kNever = 2;
struct Passage {
  double enter = kNever, leave = kNever;
};
Passage find_passage(double low, double high, double from, double to) {
  const auto when_at = [&](double side) { return (side - from) / (to - from); };
  if (!(low < high)) return {};
  if (from < low) return to >= low ? Passage{when_at(low), to >= high ? when_at(high) : kNever} : Passage{};
  if (from >= high) return to < high ? Passage{when_at(high), to < low ? when_at(low) : kNever} : Passage{};
  // False for NaN, too.
  if (!(from >= low)) return {};
  return {-1, to >= high ? when_at(high) : to < low ? when_at(low) : kNever};
}

}  // namespace

// The slab method (Kay and Kajiya, 1986): the point is inside the box where its passages between all three
// pairs of sides overlap, from the last `enter` to the first `leave`.
//           |--x--------|            time of each passage along the path
//        |------y----|
//             |-----z-------|        hit at the z side, where the last passage begins
world::Trace trace_box(const math::Bounds& box, const math::Vec3& start, const math::Vec3& end) {
  world::Trace trace;
  trace.end = end;
  trace.in_open = true;
  double enter = -1, leave = kNever;
  int axis_met = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const Passage passage = find_passage(box.mins[axis], box.maxs[axis], start[axis], end[axis]);
    leave = std::min(leave, passage.leave);
    if (passage.enter <= enter) continue;
    enter = passage.enter;
    axis_met = axis;
  }
  if (enter >= leave || enter > 1) return trace;
  if (enter < 0) {
    trace.start_solid = true;
    trace.all_solid = leave == kNever;
    trace.in_open = !trace.all_solid;
    return trace;
  }
  const double from = start[axis_met], to = end[axis_met];
  const double along = std::max(0.0, enter - kSurfaceGap / std::abs(to - from));
  trace.fraction = static_cast<float>(along);
  trace.end = math::Vec3(math::Vec3d(start) + (math::Vec3d(end) - math::Vec3d(start)) * along);
  const bool from_above = from > to;
  trace.plane_normal[axis_met] = from_above ? 1.0f : -1.0f;
  trace.plane_distance = from_above ? box.maxs[axis_met] : -box.mins[axis_met];
  return trace;
}

// `found` is used as a stack (see Scratch): touch functions may trace again while a caller iterates over it.
EntityTrace trace_move(GameWorld& io_world, const math::Vec3& start, const math::Vec3& mins,
                       const math::Vec3& maxs, const math::Vec3& end, MoveKind kind,
                       vm::EntityIndex passing) {
  const Edict passing_edict = io_world.edicts.at(passing);
  const Mover mover{start,
                    end,
                    {mins, maxs},
                    kind == MoveKind::kMissile ? kMissileBox : math::Bounds{mins, maxs},
                    kind,
                    passing,
                    passing_edict[field::kOwner],
                    passing_edict[field::kSize].x != 0};
  EntityTrace nearest;
  nearest.trace = trace_model(*io_world.level, world::ModelIndex{0}, math::Vec3(0.0f), mover);
  nearest.hit = nearest.trace.fraction < 1 || nearest.trace.start_solid;

  std::vector<vm::EntityIndex>& found = io_world.scratch.found;
  const std::size_t first = found.size();
  io_world.areas.find(swept_box(mover, nearest.trace.end), AreaKind::kSolid, found);
  for (std::size_t i = first; i < found.size() && !nearest.trace.all_solid; ++i) {
    const Edict edict = io_world.edicts[found[i]];
    if (can_collide(mover, edict)) keep_nearer(trace_entity(io_world, edict, mover), found[i], nearest);
  }
  found.resize(first);
  return nearest;
}

// Game code has no names for currents. They count as water, as in stock Quake.
world::Contents point_contents(const GameWorld& world, const math::Vec3& point) {
  const world::Contents contents = world::point_contents(*world.level, point, world.liquids);
  const bool is_current = contents <= world::Contents::kCurrent0 && contents >= world::Contents::kCurrentDown;
  return is_current ? world::Contents::kWater : contents;
}

// A trace of length 0 finds out what the box starts in.
bool is_stuck(GameWorld& io_world, vm::EntityIndex entity) {
  const Edict edict = io_world.edicts[entity];
  const math::Vec3 origin = edict[field::kOrigin];
  return trace_move(io_world, origin, edict[field::kMins], edict[field::kMaxs], origin, MoveKind::kNormal,
                    entity)
      .trace.start_solid;
}

}  // namespace temblor::server
