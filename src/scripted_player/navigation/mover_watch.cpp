#include "scripted_player/navigation/mover_watch.h"

#include <cmath>

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kThere_units = 2, kTrainThere_units = 12;

}  // namespace

void MoverWatch::look(server::Game& io_game, int items) {
  items_ = items;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Mover& mover = facts_->movers[i];
    const MoverPart& part = mover.parts[0];
    Seen& seen = seen_[i];
    server::GameWorld& world = io_game.world();
    if (!server::is_there(world, part.entity) || world.edicts[part.entity].solid() != server::Solid::kBsp) {
      seen.is_gone = true;
      seen.state = mover.kind == MoverKind::kWall ? 1 : mover.states - 1;
      continue;
    }
    const server::Edict edict = world.edicts[part.entity];
    const math::Vec3 before = seen.origin;
    seen.origin = edict[field::kOrigin];
    seen.velocity = edict[field::kVelocity];
    seen.is_moving = seen.velocity != math::Vec3(0.0f);
    seen.waits = edict[field::kNextThink] <= edict[field::kLocalTime];
    if (seen.is_there && seen.origin != before) seen.has_moved = true;
    seen.is_there = true;
    seen.state = seen.heads_for = -1;
    const float near = mover.kind == MoverKind::kTrain ? kTrainThere_units : kThere_units;
    for (int state = mover.states - 1; state >= 0; --state) {
      const math::Vec3 way = part.places[static_cast<std::size_t>(state)] - seen.origin;
      if (glm::length(way) < near) seen.state = state;
      if (seen.is_moving && glm::length(way) > 0 &&
          glm::dot(way, seen.velocity) > 0.99f * glm::length(way) * glm::length(seen.velocity))
        seen.heads_for = state;
    }
    if (seen.state == mover.states - 1) seen.was_opened = true;
  }
}

Access MoverWatch::access(int mover, int state) const {
  const Mover& m = facts_->movers[static_cast<std::size_t>(mover)];
  const Seen& seen = seen_[static_cast<std::size_t>(mover)];
  if (seen.is_gone) return Access::kNow;
  if (m.kind == MoverKind::kWall) return state == 0 ? Access::kNow : Access::kLocked;
  if (seen.state == state || seen.heads_for == state) return Access::kNow;
  if (m.kind == MoverKind::kTrain) return access_train(m, seen);
  if (m.kind == MoverKind::kLift)
    return m.opens_by_itself || seen.has_moved ? Access::kSelf : Access::kLocked;
  return access_door(m, seen, state);
}

Access MoverWatch::access_door(const Mover& mover, const Seen& seen, int state) const {
  if (state == 0) {
    if (mover.toggles) return Access::kLocked;
    return mover.stays_open || mover.key != 0 ? Access::kNever : Access::kSelf;
  }
  // A secret door on its way out, or back to come again.
  if (mover.kind == MoverKind::kSecretDoor && seen.state != 0) return Access::kSelf;
  if (mover.key != 0) return (items_ & mover.key) != 0 ? Access::kSelf : Access::kLocked;
  return mover.opens_by_itself ? Access::kSelf : Access::kLocked;
}

Access MoverWatch::access_train(const Mover& mover, const Seen& seen) const {
  if (!seen.is_moving && seen.waits)
    return seen.has_moved || mover.opens_by_itself ? Access::kNever : Access::kLocked;
  return Access::kSelf;
}

Access MoverWatch::access_any(int mover, std::uint32_t states) const {
  Access best = Access::kNever;
  for (int state = 0; state < facts_->movers[static_cast<std::size_t>(mover)].states; ++state)
    if ((states >> state & 1) != 0) best = std::min(best, access(mover, state));
  return best;
}

bool MoverWatch::is_in(int mover, std::uint32_t states) const {
  const Seen& seen = seen_[static_cast<std::size_t>(mover)];
  if (seen.is_gone) return true;
  return seen.state >= 0 && (states >> seen.state & 1) != 0;
}

}  // namespace temblor::player
