// Method: a depth-first search with its own stack (chain_), since chains may be hundreds of portals long. For
// each portal that it tries, it
//   1. drops it if all that might be seen through it has been seen already;
//   2. cuts it by the separators of the chain's first and last portals, and drops it if nothing is left;
//   3. makes the separators of what is left, and drops clusters whose boxes are outside of them.
#include "compiler/vis/flow/portal_flow.h"

#include <algorithm>
#include <bit>

namespace temblor::compiler::vis {

namespace {

using Word = BitMatrix::Word;

// Portals cut in one search until it is bounded, and until it ends. A few portals of ordinary levels exceed
// the first limit, none exceed the second.
constexpr std::size_t kBoundCuts = 4000, kMaxCuts = 30'000;

// out_both = a & b. Returns whether that has a bit that `seen` lacks.
bool narrow(std::span<const Word> a, std::span<const Word> b, std::span<const Word> seen,
            std::span<Word> out_both) {
  Word fresh = 0;
  for (std::size_t i = 0; i < out_both.size(); ++i) {
    out_both[i] = a[i] & b[i];
    fresh |= out_both[i] & ~seen[i];
  }
  return fresh != 0;
}

}  // namespace

PortalFlow::Link& PortalFlow::link(std::size_t depth) {
  while (chain_.size() <= depth) chain_.emplace_back();
  return chain_[depth];
}

// Prepares a link for trying the portals of the cluster beyond.
void PortalFlow::begin_link(std::uint32_t portal, std::size_t cut_limit, Link& out_link) const {
  const std::uint32_t cluster = graph_.portals[portal].to;
  out_link.portal = portal;
  out_link.next = graph_.first_exit[cluster];
  out_link.end = graph_.first_exit[cluster + 1];
  out_link.cut_limit = cut_limit;
}

// The cut limit of a link that follows `from`. Cuts are divided evenly among the portal that is being tried
// and those after it; those that it does not need are left to them.
std::size_t PortalFlow::share_cuts(const Link& from) const {
  if (!shares_cuts_) return from.cut_limit;
  const std::size_t left = from.cut_limit - std::min(cuts_, from.cut_limit);
  return cuts_ + left / (from.end - from.next + 1);
}

// Cuts the next portal to what lines through the chain can reach, and the first portal to what can see the
// next one. `direct`: the chain is only the first portal. Returns false if nothing is left.
bool PortalFlow::cut_to_lines(Link& from, Link& io_to, bool direct) {
  const HalfSpace& beyond_source = graph_.facings[chain_[0].portal].beyond;
  const Facing& facing = graph_.facings[io_to.portal];
  if (find_side(facing, beyond_source) == Side::kOutside) return false;
  if (std::ranges::any_of(from.separators.all(),
                          [&](const HalfSpace& space) { return find_side(facing, space) == Side::kOutside; }))
    return false;

  io_to.pass = Winding(graph_.find_corners(io_to.portal));
  if (find_side(facing, beyond_source) == Side::kAcross && cut(io_to.pass, beyond_source) == Left::kNothing)
    return false;
  if (!direct && cut(io_to.pass, graph_.facings[from.portal].beyond) == Left::kNothing) return false;
  for (const HalfSpace& space : from.separators.all())
    if (find_side(facing, space) == Side::kAcross && cut(io_to.pass, space) == Left::kNothing) return false;

  io_to.source = from.source;
  return cut(io_to.source, facing.beyond.flipped()) != Left::kNothing;
}

// Removes clusters that are outside the reach of the chain's lines from those that might still be seen.
// Returns false if no unseen one is left.
bool PortalFlow::drop_hidden(Link& io_link, std::span<const Word> seen) {
  Word fresh = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (Word rest = io_link.might[i] & ~seen[i]; rest != 0; rest &= rest - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(rest));
      const ClusterBox& box = graph_.boxes[i * 64 + bit];
      if (std::ranges::any_of(io_link.separators.all(),
                              [&](const HalfSpace& space) { return box.highest(space) <= kEpsilon; }))
        io_link.might[i] &= ~(Word{1} << bit);
    }
    fresh |= io_link.might[i] & ~seen[i];
  }
  return fresh != 0;
}

// Tries to append a portal to the chain. Returns false if nothing new can be seen through it.
bool PortalFlow::extend(std::size_t depth, std::uint32_t portal, const FlowBounds& bounds,
                        std::span<Word> io_seen) {
  const DirectedPortal& exit = graph_.portals[portal];
  Link& to = link(depth + 1);
  Link& from = chain_[depth];
  // A straight line crosses an opening only once, in one direction.
  if (on_chain_[portal] != 0 || on_chain_[exit.reverse] != 0) return false;
  if (!has_bit(from.might, exit.to) || !bounds.may_see(graph_.portals[chain_[0].portal].from, exit))
    return false;
  to.might.resize(from.might.size());
  if (!narrow(from.might, bounds.row(portal), io_seen, to.might)) return false;
  ++cuts_;
  begin_link(portal, share_cuts(from), to);
  if (!cut_to_lines(from, to, depth == 0)) return false;
  set_bit(io_seen, exit.to);
  find_separators({to.source, graph_.facings[chain_[0].portal].beyond},
                  {to.pass, graph_.facings[portal].beyond}, to.separators);
  if (!drop_hidden(to, io_seen)) return false;
  on_chain_[portal] = 1;
  return true;
}

// Restricts the current search, which has reached `depth`, to what Reach finds.
void PortalFlow::tighten(std::uint32_t portal, std::size_t depth, const FlowBounds& bounds,
                         std::span<Word> io_seen) {
  bound_.resize(io_seen.size());
  reach_.run(portal, bounds, chain_[0].might, bound_);
  for (std::size_t i = 0; i < bound_.size(); ++i) {
    io_seen[i] &= bound_[i];
    for (std::size_t link_depth = 0; link_depth <= depth; ++link_depth)
      chain_[link_depth].might[i] &= bound_[i];
  }
}

// Ends the chain's last link: all that might be seen through portals that were not tried counts as seen.
void PortalFlow::add_untried(const FlowBounds& bounds, Link& io_last, std::span<Word> io_seen) const {
  for (; io_last.next < io_last.end; ++io_last.next) {
    const DirectedPortal& exit = graph_.portals[io_last.next];
    if (on_chain_[io_last.next] != 0 || on_chain_[exit.reverse] != 0 || !has_bit(io_last.might, exit.to))
      continue;
    const auto row = bounds.row(io_last.next);
    for (std::size_t i = 0; i < io_seen.size(); ++i) io_seen[i] |= io_last.might[i] & row[i];
  }
}

// Chains end because an opening is entered only once (on_chain_), and because `might` shrinks on the way.
bool PortalFlow::run(std::uint32_t portal, const FlowBounds& bounds, std::size_t shared_cuts,
                     const std::atomic<bool>& stop, std::span<Word> io_seen) {
  Link& first = link(0);
  begin_link(portal, shared_cuts > 0 ? shared_cuts : kMaxCuts, first);
  first.source = Winding(graph_.find_corners(portal));
  first.separators.count = 0;
  const auto base_row = bounds.row(portal);
  first.might.assign(base_row.begin(), base_row.end());
  set_bit(io_seen, graph_.portals[portal].to);
  std::ranges::fill(on_chain_, std::uint8_t{0});
  on_chain_[portal] = 1;
  cuts_ = 0;
  shares_cuts_ = shared_cuts > 0;
  bool is_bounded = shares_cuts_;
  for (std::size_t depth = 0;;) {
    if (cuts_ >= kBoundCuts && !is_bounded) {
      tighten(portal, depth, bounds, io_seen);
      is_bounded = true;
    }
    Link& last = chain_[depth];
    if (cuts_ >= last.cut_limit) add_untried(bounds, last, io_seen);
    if (last.next == last.end) {
      on_chain_[last.portal] = 0;
      if (depth-- == 0) return true;
      continue;
    }
    if (extend(depth, last.next++, bounds, io_seen)) ++depth;
    if (stop.load(std::memory_order_relaxed)) return false;
  }
}

}  // namespace temblor::compiler::vis
