// The entities of a game ("edicts", as the original calls their records).
// An entity's fields are words in the QuakeC machine. This part knows which entities are in use, and what the
// server stores for each one besides its fields:
//    number:   0        1 .. client_count        client_count + 1 ..
//              world    players                  monsters, items, doors, missiles, ...
//              always   always there, even       freed and used again
//              there    if nobody plays
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "net/protocol/server_message.h"
#include "server/game/entity_fields.h"
#include "vm/machine.h"
#include "world/level.h"

namespace temblor::server {

// The server's data for an entity besides its fields. QuakeC does not see it.
struct EdictState {
  // The level's leaves that its box touches, for the PVS; link() finds them. An entity in more than
  // kMaxLeaves counts as visible from everywhere, and its list is empty.
  static constexpr std::size_t kMaxLeaves = 32;

  bool is_free = false;
  // The game time at which it was freed last.
  double freed_at_s = 0;
  std::vector<world::LeafIndex> leaves;
  bool is_in_too_many_leaves = false;
  // The state that snapshots are compared with; see baselines.h.
  net::Baseline baseline;
};

class Edicts {
 public:
  // Entities 1 to `client_count` are for players; spawn() never returns them. `io_machine` must outlive this
  // object, and CHECKs that it has room for them.
  Edicts(vm::Machine& io_machine, std::uint32_t client_count);

  std::uint32_t count() const { return machine_->entity_count(); }
  std::uint32_t client_count() const { return client_count_; }
  bool is_client(vm::EntityIndex index) const {
    return index != vm::kWorld && base::to_size(index) <= client_count_;
  }
  // CHECKs that the entity exists.
  Edict operator[](vm::EntityIndex index) { return {index, machine_->entity(index)}; }
  Edict world() { return (*this)[vm::kWorld]; }
  // An entity number from QuakeC. If there is no such entity, the world.
  Edict at(vm::EntityIndex value) { return (*this)[base::to_size(value) < count() ? value : vm::kWorld]; }
  EdictState& state(vm::EntityIndex index) { return states_[base::to_size(index)]; }
  const EdictState& state(vm::EntityIndex index) const { return states_[base::to_size(index)]; }
  bool is_free(vm::EntityIndex index) const { return states_[base::to_size(index)].is_free; }

  // Makes an entity with all fields 0. It reuses a number that was freed before time 2 or more than 0.5 s
  // ago: clients blend what they last saw under a number with what they see next. kTooLarge past the
  // machine's limit.
  base::Result<vm::EntityIndex> spawn(double time_s);
  // Frees an entity, which the caller has unlinked. QuakeC that still refers to it sees an entity without
  // model at 0 0 0. The world, players and free entities stay as they are.
  void free(vm::EntityIndex index, double time_s);
  // For saved games: sets the number of entities, all in use. kTooLarge past the machine's limit; kUsage if
  // there would be fewer than the world and the players.
  base::Status set_count(std::uint32_t count);

 private:
  void follow_count();

  vm::Machine* machine_;
  std::uint32_t client_count_;
  std::uint32_t free_count_ = 0;
  std::vector<EdictState> states_;
};

}  // namespace temblor::server
