// Method: a work list. Each portal has the hull of all that was reached of it; when the hull grows, the
// portal is queued again, the nearest first, and what can be seen through it is cut by the separators of the
// source and that hull. Hulls are larger than what chains reach one by one, so the result is a bound.
#include "compiler/vis/flow/reach.h"

#include <algorithm>

#include "compiler/vis/flow/hull.h"

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
  if (!slot.queued) queue_.push({glm::length(graph_.facings[portal].center - source_center_), slot_index});
  slot.queued = true;
}

// Cuts a portal to what lines from the source through `from` can reach. Returns false if nothing is left.
// Spheres decide most cases.
bool Reach::cut_to_reach(const DirectedPortal& source, const Slot& from, std::uint32_t target,
                         Winding& out_piece) const {
  const Facing& facing = graph_.facings[target];
  const auto is_outside = [&](const HalfSpace& space) { return find_side(facing, space) == Side::kOutside; };
  const auto is_kept = [&](const HalfSpace& space) {
    return find_side(facing, space) == Side::kInside || cut(out_piece, space);
  };
  if (is_outside(source.beyond) || std::ranges::any_of(separators_.all(), is_outside)) return false;
  // Some of the source must be on the near side of the target, or nothing can enter it.
  if (std::ranges::none_of(source.winding.corners(), [&](const math::Vec3d& corner) {
        return facing.beyond.above(corner) < -kEpsilon;
      }))
    return false;
  out_piece = graph_.portals[target].winding;
  const DirectedPortal& pass = graph_.portals[from.portal];
  if (!is_kept(source.beyond) || (&pass != &source && !is_kept(pass.beyond))) return false;
  return std::ranges::all_of(separators_.all(), is_kept);
}

// Passes sight lines from the source through the reached part of one portal on to the next portals.
void Reach::pass_on(const DirectedPortal& source, const Slot& from, const FlowBounds& bounds,
                    std::span<const BitMatrix::Word> might, std::span<BitMatrix::Word> io_bound) {
  const DirectedPortal& pass = graph_.portals[from.portal];
  separators_.count = 0;
  if (&pass != &source)
    find_separators({source.winding, source.beyond}, {from.reached, pass.beyond}, separators_);
  const auto beyond_pass = bounds.row(from.portal);
  Winding piece;
  for (const Exit& exit : graph_.exits_from(pass.to)) {
    if (exit.portal / 2 == from.portal / 2 || !has_bit(might, exit.to) || !has_bit(beyond_pass, exit.to) ||
        !cut_to_reach(source, from, exit.portal, piece))
      continue;
    set_bit(io_bound, exit.to);
    reach(exit.portal, piece);
  }
}

void Reach::run(std::uint32_t portal, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
                std::span<BitMatrix::Word> out_bound) {
  const DirectedPortal& source = graph_.portals[portal];
  std::ranges::fill(out_bound, BitMatrix::Word{0});
  set_bit(out_bound, source.to);
  source_center_ = graph_.facings[portal].center;
  reach(portal, source.winding);
  while (!queue_.empty()) {
    Slot& slot = slots_[queue_.top().slot];
    queue_.pop();
    slot.queued = false;
    pass_on(source, slot, bounds, might, out_bound);
  }
  for (const Slot& slot : slots_) slot_of_portal_[slot.portal] = kNoSlot;
  slots_.clear();
}

}  // namespace temblor::compiler::vis
