// The entities of a game: their words are the machine's; which are in use, and what the server keeps about
// each, is here.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "net/protocol/server_message.h"
#include "server/game/entity_fields.h"
#include "vm/machine.h"
#include "world/level.h"

namespace temblor::server {

// What QuakeC does not see of an entity.
struct EdictState {
  // Of its box, by link(): leaves of the world that it touches, for the PVS. With more than kMaxLeaves it
  // counts as seen from everywhere, and the list is empty.
  static constexpr std::size_t kMaxLeaves = 32;

  bool is_free = false;
  double freed_at_s = 0;
  std::vector<world::LeafIndex> leaves;
  bool is_in_too_many_leaves = false;
  net::Baseline baseline;
};

class Edicts {
 public:
  // `client_count`: entities 1 to client_count are the players', and never given out by spawn(); the machine
  // gets as many as that. It must outlive this object. CHECKs that it has room for them.
  Edicts(vm::Machine& io_machine, std::uint32_t client_count);

  std::uint32_t count() const { return machine_->entity_count(); }
  std::uint32_t client_count() const { return client_count_; }
  bool is_client(vm::EntityIndex index) const {
    return index != vm::kWorld && base::to_size(index) <= client_count_;
  }
  // CHECKs that there is such an entity.
  Edict operator[](vm::EntityIndex index) { return {index, machine_->entity(index)}; }
  Edict world() { return (*this)[vm::kWorld]; }
  // A value from QuakeC: the world for one that is no entity.
  Edict at(vm::EntityIndex value) { return (*this)[base::to_size(value) < count() ? value : vm::kWorld]; }
  EdictState& state(vm::EntityIndex index) { return states_[base::to_size(index)]; }
  const EdictState& state(vm::EntityIndex index) const { return states_[base::to_size(index)]; }
  bool is_free(vm::EntityIndex index) const { return states_[base::to_size(index)].is_free; }

  // A new entity, its words all 0. A place that was freed before time 2, or more than 0.5 s ago, is used
  // again (clients still blend what they saw there with what they see next). kTooLarge when there is no
  // place.
  base::Result<vm::EntityIndex> spawn(double time_s);
  // Frees a place; whoever still refers to it sees an entity that is nowhere. The caller unlinks it first.
  // The world and players' places stay, and nothing happens to one that is free.
  void free(vm::EntityIndex index, double time_s);
  // For loading: exactly that many, all in use. kTooLarge past the machine's limit; kUsage where there would
  // be fewer than the players need.
  base::Status set_count(std::uint32_t count);

 private:
  void follow_count();

  vm::Machine* machine_;
  std::uint32_t client_count_;
  std::uint32_t free_count_ = 0;
  std::vector<EdictState> states_;
};

}  // namespace temblor::server
