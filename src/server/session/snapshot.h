// The state of all entities at the end of a tick, each already encoded as the bytes that clients are sent.
// Each client's datagram is then only a selection of them, so the cost of encoding does not grow with the
// number of players.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "net/delta/snapshot_state.h"
#include "server/game/baselines.h"
#include "server/game/game_world.h"
#include "server/game/outbox.h"
#include "vm/machine.h"

namespace temblor::server {

struct Snapshot {
  // A crouching player is there twice: for itself, at its origin, and lowered for all others.
  enum class Viewers : std::uint8_t { kAll, kItself, kOthers };
  struct Entity {
    vm::EntityIndex index{};
    vm::EntityIndex owner{};  // of a missile: who fired it
    bool is_visible = false;  // has a model; without one, only the entity's own player gets it
    Viewers viewers = Viewers::kAll;
    math::Vec3 origin{0.0f};
    std::size_t begin = 0, end = 0;  // of its bytes in `bytes`
  };
  std::vector<Entity> entities;                   // in order of number
  std::vector<net::SnapshotState::Entity> words;  // the same entities in the form that deltas compare
  base::ByteWriter bytes;
  std::size_t unnumbered = 0;  // visible entities for which the dialect has no number

  base::Bytes entity_bytes(const Entity& entity) const {
    return base::Bytes(bytes.view()).subspan(entity.begin, entity.end - entity.begin);
  }
};

// `fields` are those of the running program. Reuses io_snapshot's memory.
void take_snapshot(GameWorld& io_world, const vm::Machine& machine, const LookFields& fields,
                   const net::Dialect& dialect, Snapshot& io_snapshot);

}  // namespace temblor::server
