#include "server/game/edicts.h"

#include <algorithm>

namespace temblor::server {
namespace {

constexpr double kReuseAtOnceBefore_s = 2;  // game time; no client has seen anything of the level yet
constexpr double kReuseAfter_s = 0.5;

}  // namespace

Edicts::Edicts(vm::Machine& io_machine, std::uint32_t client_count)
    : machine_(&io_machine), client_count_(client_count) {
  const std::uint32_t needed = client_count + 1;
  if (count() < needed) {
    const base::Status status = machine_->set_entity_count(needed);
    CHECK(status.ok(), "{} players: {}", client_count, status.error().message());
  }
  follow_count();
}

// Reserves all that an entity may need, so that link() never allocates during a tick.
void Edicts::follow_count() {
  const std::size_t before = states_.size();
  states_.resize(count());
  for (std::size_t i = before; i < states_.size(); ++i) states_[i].leaves.reserve(EdictState::kMaxLeaves);
}

// Takes the lowest free number, as the original does: numbers decide the order of physics.
base::Result<vm::EntityIndex> Edicts::spawn(double time_s) {
  if (free_count_ > 0) {
    for (std::size_t i = client_count_ + 1; i < states_.size(); ++i) {
      EdictState& state = states_[i];
      if (!state.is_free) continue;
      if (state.freed_at_s >= kReuseAtOnceBefore_s && time_s - state.freed_at_s <= kReuseAfter_s) continue;
      const auto index = base::to_index<vm::EntityIndex>(i);
      std::ranges::fill((*this)[index].words(), 0u);
      state.is_free = false;
      state.leaves.clear();
      state.is_in_too_many_leaves = false;
      --free_count_;
      return index;
    }
  }
  const auto index = static_cast<vm::EntityIndex>(count());
  TRY_STATUS(machine_->set_entity_count(count() + 1));
  follow_count();
  return index;
}

void Edicts::free(vm::EntityIndex index, double time_s) {
  if (base::to_size(index) <= client_count_ || is_free(index)) return;
  EdictState& state = states_[base::to_size(index)];
  state.is_free = true;
  state.freed_at_s = time_s;
  state.leaves.clear();
  state.is_in_too_many_leaves = false;
  ++free_count_;
  // QuakeC may still read its fields, but it is not drawn, blocks nothing, and does not think.
  const Edict edict = (*this)[index];
  edict.set(field::kModel, vm::kEmptyString);
  edict.set(field::kTakeDamage, 0);
  edict.set(field::kModelIndex, 0);
  edict.set(field::kColorMap, 0);
  edict.set(field::kSkin, 0);
  edict.set(field::kFrame, 0);
  edict.set(field::kOrigin, math::Vec3(0.0f));
  edict.set(field::kAngles, math::Vec3(0.0f));
  edict.set(field::kNextThink, -1);
  edict.set(field::kSolid, 0);
}

// Everything counts as used afterward; the caller frees what a saved game has as free.
base::Status Edicts::set_count(std::uint32_t count) {
  if (count <= client_count_)
    return base::error(base::ErrorCode::kUsage, "{} entities, but {} players", count, client_count_);
  TRY_STATUS(machine_->set_entity_count(count));
  follow_count();
  for (EdictState& state : states_) state.is_free = false;
  free_count_ = 0;
  return base::Ok{};
}

}  // namespace temblor::server
