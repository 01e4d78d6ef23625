// Method: a work list. Each portal has the hull of all that was reached of it; when the hull grows, the
// portal is queued again and what can be seen through it is cut by the separators of the source and that
// hull. Hulls are larger than what chains reach one by one, so the result is a bound.
#include "compiler/vis/flow/reach.h"

#include <algorithm>

#include "compiler/vis/flow/hull.h"
#include "compiler/vis/flow/separators.h"

namespace temblor::compiler::vis {

namespace {

// A portal whose reached part has grown this often counts as reached as a whole, so that small steps come to
// an end.
constexpr int kMaxGrowths = 8;

}  // namespace

// Adds a piece to the reached part of a portal, and queues the portal if that part has grown.
void Reach::reach(std::uint32_t portal, const Winding& piece) {
  std::uint32_t& slot_index = slot_of_portal_[portal];
  const bool is_new = slot_index == kNoSlot;
  if (is_new) {
    slot_index = static_cast<std::uint32_t>(slots_.size());
    slots_.push_back({portal, piece, 0, false});
  }
  Slot& slot = slots_[slot_index];
  const DirectedPortal& directed = graph_.portals[portal];
  if (!is_new) {
    if (slot.growths > kMaxGrowths || contains(slot.reached, piece, directed.beyond.normal)) return;
    ++slot.growths;
    if (slot.growths > kMaxGrowths || !grow_hull(slot.reached, piece, directed.beyond.normal)) {
      slot.growths = kMaxGrowths + 1;
      slot.reached = directed.winding;
    }
  }
  if (!slot.queued) queue_.push_back(slot_index);
  slot.queued = true;
}

// Passes sight lines from the source through the reached part of one portal on to the next portals.
void Reach::pass_on(const DirectedPortal& source, const Slot& from, const FlowBounds& bounds,
                    std::span<const BitMatrix::Word> might, std::span<BitMatrix::Word> io_bound) {
  const DirectedPortal& pass = graph_.portals[from.portal];
  const bool is_source = &pass == &source;
  Separators separators;
  if (!is_source) find_separators({source.winding, source.beyond}, {from.reached, pass.beyond}, separators);
  const auto beyond_pass = bounds.row(from.portal);
  for (const std::uint32_t next : graph_.portals_from(pass.to)) {
    const DirectedPortal& target = graph_.portals[next];
    if (next / 2 == from.portal / 2 || !has_bit(might, target.to) || !has_bit(beyond_pass, target.to))
      continue;
    // Some of the source must be on the near side of the target, or nothing can enter it.
    Winding facing_target = source.winding;
    if (!cut(facing_target, target.beyond.flipped())) continue;
    Winding piece = target.winding;
    if (!cut(piece, source.beyond) || (!is_source && !cut(piece, pass.beyond))) continue;
    if (!std::ranges::all_of(separators.all(), [&](const HalfSpace& space) { return cut(piece, space); }))
      continue;
    set_bit(io_bound, target.to);
    reach(next, piece);
  }
}

void Reach::run(std::uint32_t portal, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
                std::span<BitMatrix::Word> out_bound) {
  const DirectedPortal& source = graph_.portals[portal];
  std::ranges::fill(out_bound, BitMatrix::Word{0});
  set_bit(out_bound, source.to);
  reach(portal, source.winding);
  while (!queue_.empty()) {
    Slot& slot = slots_[queue_.front()];
    queue_.pop_front();
    slot.queued = false;
    pass_on(source, slot, bounds, might, out_bound);
  }
  for (const Slot& slot : slots_) slot_of_portal_[slot.portal] = kNoSlot;
  slots_.clear();
}

}  // namespace temblor::compiler::vis
