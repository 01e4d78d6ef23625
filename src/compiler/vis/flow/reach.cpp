// Method: a work list. Each portal has the hull of all that was reached of it; when the hull grows, the
// portal is queued again, the nearest first, and what can be seen through it is cut by the separators of the
// source and that hull. Hulls are larger than what chains reach one by one, so the result is a bound.
#include "compiler/vis/flow/reach.h"

#include <algorithm>
#include <array>

#include "compiler/vis/flow/hull.h"

namespace temblor::compiler::vis {

namespace {

// A portal whose reached part has grown this often counts as reached as a whole, so that small steps come to
// an end.
constexpr int kMaxGrowths = 8;

}  // namespace

// Adds a piece to the reached part of a portal, and queues the portal if that part has grown.
void Reach::reach(std::uint32_t portal, Left part, const Winding& piece) {
  std::uint32_t& slot_index = slot_of_portal_[portal];
  const bool is_new = slot_index == kNoSlot;
  if (is_new) {
    slot_index = static_cast<std::uint32_t>(slots_.size());
    slots_.push_back({portal, 0, false, part == Left::kWhole, piece});
  }
  Slot& slot = slots_[slot_index];
  if (!is_new) {
    const math::Vec3d& normal = graph_.facings[portal].beyond.normal;
    if (slot.whole || (part == Left::kSome && contains(slot.reached, piece, normal))) return;
    slot.whole =
        part == Left::kWhole || ++slot.growths > kMaxGrowths || !grow_hull(slot.reached, piece, normal);
    if (slot.whole) slot.reached = Winding(graph_.find_corners(portal));
  }
  if (!slot.queued)
    queue_.push({glm::length(graph_.facings[portal].center - graph_.facings[source_].center), slot_index});
  slot.queued = true;
}

// Cuts a portal to what lines from the source through `from` can reach. Spheres decide most cases.
Left Reach::cut_to_reach(std::uint32_t from, std::uint32_t target, Winding& out_piece) const {
  const Facing &facing = graph_.facings[target], &source = graph_.facings[source_];
  std::array<const HalfSpace*, 2 * kMaxWindingPoints + 2> across;
  std::size_t across_count = 0;
  const auto is_outside = [&](const HalfSpace& space) {
    const Side side = find_side(facing, space);
    if (side == Side::kAcross) across[across_count++] = &space;
    return side == Side::kOutside;
  };
  if (is_outside(source.beyond) || std::ranges::any_of(separators_.all(), is_outside)) return Left::kNothing;
  // Some of the source must be on the near side of the target, or nothing can enter it.
  if (facing.beyond.above(source.center) >= -kEpsilon &&
      std::ranges::none_of(graph_.find_corners(source_), [&](const math::Vec3d& corner) {
        return facing.beyond.above(corner) < -kEpsilon;
      }))
    return Left::kNothing;
  if (from != source_ && is_outside(graph_.facings[from].beyond)) return Left::kNothing;
  out_piece = Winding(graph_.find_corners(target));
  bool is_whole = true;
  for (std::size_t i = 0; i < across_count; ++i) {
    const Left result = cut(out_piece, *across[i]);
    if (result == Left::kNothing) return Left::kNothing;
    is_whole &= result == Left::kWhole;
  }
  return is_whole ? Left::kWhole : Left::kSome;
}

// Passes sight lines from the source through the reached part of one portal on to the next portals.
void Reach::pass_on(std::uint32_t slot, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
                    std::span<BitMatrix::Word> io_bound) {
  const std::uint32_t from = slots_[slot].portal;
  separators_.count = 0;
  if (from != source_) {
    const Winding source(graph_.find_corners(source_));
    find_separators({source, graph_.facings[source_].beyond},
                    {slots_[slot].reached, graph_.facings[from].beyond}, separators_);
  }
  const std::uint32_t cluster = graph_.portals[from].to, first = graph_.first_exit[cluster];
  Winding piece;
  for (std::uint32_t exit = first; exit < graph_.first_exit[cluster + 1]; ++exit) {
    const DirectedPortal& portal = graph_.portals[exit];
    if (!bounds.may_enter(from, exit - first) || !has_bit(might, portal.to) ||
        !bounds.may_see(graph_.portals[source_].from, portal) || is_whole(exit))
      continue;
    const Left part = cut_to_reach(from, exit, piece);
    if (part == Left::kNothing) continue;
    set_bit(io_bound, portal.to);
    reach(exit, part, piece);
  }
}

void Reach::run(std::uint32_t portal, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
                std::span<BitMatrix::Word> out_bound) {
  std::ranges::fill(out_bound, BitMatrix::Word{0});
  set_bit(out_bound, graph_.portals[portal].to);
  source_ = portal;
  reach(portal, Left::kWhole, Winding(graph_.find_corners(portal)));
  while (!queue_.empty()) {
    const std::uint32_t slot = queue_.top().slot;
    queue_.pop();
    slots_[slot].queued = false;
    pass_on(slot, bounds, might, out_bound);
  }
  for (const Slot& slot : slots_) slot_of_portal_[slot.portal] = kNoSlot;
  slots_.clear();
}

}  // namespace temblor::compiler::vis
