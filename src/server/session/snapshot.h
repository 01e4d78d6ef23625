// All entities as they stand at a tick's end, each already in the bytes that any client may be told: who is
// told what is only a choice among them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/bytes.h"
#include "net/delta/snapshot_state.h"
#include "server/game_world.h"
#include "server/session/baselines.h"
#include "server/session/outbox.h"
#include "vm/machine.h"

namespace temblor::server {

struct Snapshot {
  struct Entity {
    vm::EntityIndex index{};
    bool shows_something = false;  // has a model; else only its own player is told of it
    math::Vec3 origin{0.0f};
    std::size_t begin = 0, end = 0;  // of its update, in `bytes`
  };
  std::vector<Entity> entities;                   // in order of number
  std::vector<net::SnapshotState::Entity> words;  // of the same ones: their updates, to be compared
  base::ByteWriter bytes;
  std::size_t unnumbered = 0;  // entities that the dialect has no number for

  base::Bytes update_of(const Entity& entity) const {
    return base::Bytes(bytes.view()).subspan(entity.begin, entity.end - entity.begin);
  }
};

// `fields`: of the program that runs. Keeps io_snapshot's memory.
void take_snapshot(GameWorld& io_world, const vm::Machine& machine, const LookFields& fields,
                   const net::Dialect& dialect, Snapshot& io_snapshot);

}  // namespace temblor::server
