#include "scripted_player/navigation/mover_watch.h"

#include <cmath>

namespace temblor::player {
namespace {

namespace field = server::field;

// A mover this near to the position of a state is in it.
constexpr float kThere_units = 2, kTrainThere_units = 12;

}  // namespace

void MoverWatch::look(server::Game& io_game, int items) {
  items_ = items;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    const Mover& mover = facts_->movers[i];
    const MoverPart& part = mover.parts[0];
    MoverStatus& seen = seen_[i];
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
    seen.is_idle = edict[field::kNextThink] <= edict[field::kLocalTime];
    if (seen.is_known && seen.origin != before) seen.has_moved = true;
    seen.is_known = true;
    // Backward, so that the lowest state wins where two share a position.
    seen.state = seen.heads_for = -1;
    const float near = mover.kind == MoverKind::kTrain ? kTrainThere_units : kThere_units;
    for (int state = mover.states - 1; state >= 0; --state) {
      const math::Vec3 offset = part.places[static_cast<std::size_t>(state)] - seen.origin;
      if (glm::length(offset) < near) seen.state = state;
      // Within 8 degrees of the direction to that state.
      if (seen.is_moving && glm::length(offset) > 0 &&
          glm::dot(offset, seen.velocity) > 0.99f * glm::length(offset) * glm::length(seen.velocity))
        seen.heads_for = state;
    }
    if (seen.state == mover.states - 1) seen.was_opened = true;
  }
}

// Removed movers are no obstacle in any state. A lift that has moved once is in service, even if it had to be
// activated.
Access MoverWatch::access(int mover, int state) const {
  const Mover& m = facts_->movers[static_cast<std::size_t>(mover)];
  const MoverStatus& seen = seen_[static_cast<std::size_t>(mover)];
  if (seen.is_gone) return Access::kNow;
  if (m.kind == MoverKind::kWall) return state == 0 ? Access::kNow : Access::kLocked;
  if (seen.state == state || seen.heads_for == state) return Access::kNow;
  if (m.kind == MoverKind::kTrain) return access_train(m, seen);
  if (m.kind == MoverKind::kLift)
    return m.opens_automatically || seen.has_moved ? Access::kAutomatic : Access::kLocked;
  return access_door(m, seen, state);
}

// Opening (state > 0) takes a touch, a key, or an activation. Closing (state 0) happens without help, unless
// the door toggles or stays open; key doors always stay open.
Access MoverWatch::access_door(const Mover& mover, const MoverStatus& seen, int state) const {
  if (state == 0) {
    if (mover.toggles) return Access::kLocked;
    return mover.stays_open || mover.key != 0 ? Access::kNever : Access::kAutomatic;
  }
  // A secret door that is not closed passes its other states without help.
  if (mover.kind == MoverKind::kSecretDoor && seen.state != 0) return Access::kAutomatic;
  if (mover.key != 0) return (items_ & mover.key) != 0 ? Access::kAutomatic : Access::kLocked;
  return mover.opens_automatically ? Access::kAutomatic : Access::kLocked;
}

// A moving train passes all its corners. One that has stopped for good, after it has moved, never starts
// again.
Access MoverWatch::access_train(const Mover& mover, const MoverStatus& seen) const {
  if (!seen.is_moving && seen.is_idle)
    return seen.has_moved || mover.opens_automatically ? Access::kNever : Access::kLocked;
  return Access::kAutomatic;
}

Access MoverWatch::access_any(int mover, std::uint32_t states) const {
  Access best = Access::kNever;
  for (int state = 0; state < facts_->movers[static_cast<std::size_t>(mover)].states; ++state)
    if ((states >> state & 1) != 0) best = std::min(best, access(mover, state));
  return best;
}

bool MoverWatch::is_in(int mover, std::uint32_t states) const {
  const MoverStatus& seen = seen_[static_cast<std::size_t>(mover)];
  if (seen.is_gone) return true;
  return seen.state >= 0 && (states >> seen.state & 1) != 0;
}

}  // namespace temblor::player
