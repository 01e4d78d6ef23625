// Doors, lifts and trains ("pushers"). They move whatever stands on them or is in their way; if something
// does not fit where it is pushed, everything goes back to where it was, and QuakeC learns what blocked the
// pusher.
// A pusher has a clock of its own, ltime, which stops while it is blocked. Its nextthink is relative to that
// clock, so that a blocked door still stops at the right place.
#include <algorithm>

#include "server/physics/entity_moves.h"
#include "server/physics/moves.h"

namespace temblor::server {
namespace {

// One push. The entries of Scratch::moved from `first_moved` on belong to it.
struct PushMove {
  vm::EntityIndex pusher;
  math::Vec3 way, origin;  // the pusher's path, and where it started
  math::Bounds box;        // the pusher's, at the end of its path
  float duration_s;
  std::size_t first_moved;
};

bool can_be_pushed(const Edict& edict) {
  const MoveType type = edict.move_type();
  return type != MoveType::kPush && type != MoveType::kNone && type != MoveType::kNoClip &&
         type != MoveType::kFollow;
}

// An entity that rides the pusher moves along even if their boxes no longer touch.
bool is_in_the_way(GameWorld& io_world, const PushMove& move, const Edict& edict) {
  if (edict.has_flag(flag::kOnGround) && edict[field::kGroundEntity] == move.pusher) return true;
  const math::Vec3 mins = edict[field::kAbsMin], maxs = edict[field::kAbsMax];
  return glm::all(glm::lessThan(mins, move.box.maxs)) && glm::all(glm::greaterThan(maxs, move.box.mins)) &&
         is_stuck(io_world, edict.index());
}

// Flattens something dead in the way, so that it stops nobody any more.
bool try_flatten(const Edict& edict) {
  math::Vec3 mins = edict[field::kMins];
  if (mins.x == edict[field::kMaxs].x) return true;
  if (edict.solid() != Solid::kNot && edict.solid() != Solid::kTrigger) return false;
  mins.x = mins.y = 0;
  edict.set(field::kMins, mins);
  edict.set(field::kMaxs, mins);
  return true;
}

// Moves one entity along. false: it neither fits where it was pushed nor can be flattened. While it moves,
// the pusher is not solid, or it would stop everything in it.
base::Result<bool> carry(GameWorld& io_world, const PushMove& move, vm::EntityIndex entity) {
  Edict edict = io_world.edicts[entity];
  if (edict.move_type() != MoveType::kWalk) edict.clear_flag(flag::kOnGround);
  io_world.scratch.moved.push_back({entity, edict[field::kOrigin]});
  const float solid = io_world.edicts[move.pusher][field::kSolid];
  io_world.edicts[move.pusher].set(field::kSolid, static_cast<float>(Solid::kNot));
  TRY(const movement::Push pushed, push_entity(io_world, entity, move.way));
  if (!is_there(io_world, move.pusher)) return true;
  io_world.edicts[move.pusher].set(field::kSolid, solid);
  return pushed.is_gone || !is_stuck(io_world, entity) || try_flatten(io_world.edicts[entity]);
}

// Does nothing for an entity that QuakeC has removed in the meantime.
base::Status put_back(GameWorld& io_world, vm::EntityIndex entity, const math::Vec3& origin,
                      TouchTriggers touch) {
  if (!is_there(io_world, entity)) return base::Ok{};
  io_world.edicts[entity].set(field::kOrigin, origin);
  return link(io_world, entity, touch);
}

// The order is the original's: the blocker goes back first and touches triggers, then `blocked` is called,
// and the others follow after it.
base::Status undo(GameWorld& io_world, const PushMove& move, vm::EntityIndex blocker) {
  TRY_STATUS(put_back(io_world, blocker, io_world.scratch.moved.back().from, TouchTriggers::kYes));
  TRY_STATUS(put_back(io_world, move.pusher, move.origin, TouchTriggers::kNo));
  if (is_there(io_world, move.pusher)) {
    const Edict pusher = io_world.edicts[move.pusher];
    pusher.set(field::kLocalTime, pusher[field::kLocalTime] - move.duration_s);
    if (pusher[field::kBlocked] != vm::kNoFunction)
      TRY_STATUS(io_world.calls.call(pusher[field::kBlocked], move.pusher, blocker, io_world.time_s));
  }
  for (std::size_t i = move.first_moved; i < io_world.scratch.moved.size(); ++i) {
    const Scratch::Moved moved = io_world.scratch.moved[i];
    TRY_STATUS(put_back(io_world, moved.entity, moved.from, TouchTriggers::kNo));
  }
  return base::Ok{};
}

// Stops early if a touch function removes the pusher.
base::Status push_everything(GameWorld& io_world, const PushMove& move) {
  for (std::uint32_t i = 1; i < io_world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (io_world.edicts.is_free(entity)) continue;
    const Edict edict = io_world.edicts[entity];
    if (!can_be_pushed(edict) || !is_in_the_way(io_world, move, edict)) continue;
    TRY(const bool goes_on, carry(io_world, move, entity));
    if (!goes_on) return undo(io_world, move, entity);
    if (!is_there(io_world, move.pusher)) break;
  }
  return base::Ok{};
}

base::Status move_pusher(GameWorld& io_world, vm::EntityIndex entity, float asked_s) {
  const Edict edict = io_world.edicts[entity];
  const float before_s = edict[field::kLocalTime];
  edict.set(field::kLocalTime, before_s + asked_s);
  // The path follows from how far the clock has advanced, which is a rounded float. Five minutes into a game
  // the requested durations would add up to 0.1 units more on a long path, and a rider would sink into the
  // floor and fall through.
  const float duration_s = edict[field::kLocalTime] - before_s;
  const math::Vec3 way = edict[field::kVelocity] * duration_s;
  if (edict[field::kVelocity] == math::Vec3(0.0f)) return base::Ok{};
  std::vector<Scratch::Moved>& moved = io_world.scratch.moved;
  const PushMove move{entity,
                      way,
                      edict[field::kOrigin],
                      {edict[field::kAbsMin] + way, edict[field::kAbsMax] + way},
                      duration_s,
                      moved.size()};
  edict.set(field::kOrigin, move.origin + way);
  TRY_STATUS(link(io_world, entity, TouchTriggers::kNo));
  const base::Status status = push_everything(io_world, move);
  moved.resize(move.first_moved);
  return status;
}

}  // namespace

base::Status run_pusher(GameWorld& io_world, vm::EntityIndex entity) {
  const float before_s = io_world.edicts[entity][field::kLocalTime];
  const float think_s = io_world.edicts[entity][field::kNextThink];
  // It moves no farther than to its next think, which thus comes at the right place.
  const double until_s = std::min(double{think_s} - before_s, io_world.tick_s);
  if (until_s > 0) TRY_STATUS(move_pusher(io_world, entity, static_cast<float>(until_s)));

  if (!is_there(io_world, entity)) return base::Ok{};
  const Edict edict = io_world.edicts[entity];
  if (!(think_s > before_s && think_s <= edict[field::kLocalTime])) return base::Ok{};
  edict.set(field::kNextThink, 0);
  return io_world.calls.call(edict[field::kThink], entity, vm::kWorld, io_world.time_s);
}

}  // namespace temblor::server
