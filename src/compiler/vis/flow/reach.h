// A bound on what is seen through one portal, in time that does not grow with the number of chains of
// portals.
#pragma once

#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <vector>

#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/flow/flow_bounds.h"
#include "compiler/vis/flow/portal_graph.h"
#include "compiler/vis/flow/separators.h"
#include "compiler/vis/flow/winding.h"

namespace temblor::compiler::vis {

// PortalFlow follows each chain of portals separately, and in a large hall that the tree cut into cells there
// are more chains than can be counted. Here each portal is kept once, with the hull of what all chains reach
// of it; when that hull grows, it is passed on again. Holds the working memory of one thread.
class Reach {
 public:
  explicit Reach(const PortalGraph& graph) : graph_(graph), slot_of_portal_(graph.portals.size(), kNoSlot) {}

  // Sets the bits of all clusters of `might` that could be seen through the portal, and possibly of more.
  void run(std::uint32_t portal, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
           std::span<BitMatrix::Word> out_bound);

 private:
  static constexpr std::uint32_t kNoSlot = 0xffffffff;

  // A portal that has been reached.
  struct Slot {
    std::uint32_t portal = 0;
    int growths = 0;
    bool queued = false, whole = false;
    Winding reached;
  };

  void pass_on(std::uint32_t slot, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
               std::span<BitMatrix::Word> io_bound);
  Left cut_to_reach(std::uint32_t from, std::uint32_t target, Winding& out_piece) const;
  void reach(std::uint32_t portal, Left part, const Winding& piece);
  bool is_whole(std::uint32_t portal) const {
    return slot_of_portal_[portal] != kNoSlot && slots_[slot_of_portal_[portal]].whole;
  }

  const PortalGraph& graph_;
  std::vector<std::uint32_t> slot_of_portal_;
  // A slot whose hull has grown. The nearest comes first: what reaches a portal mostly comes through nearer
  // ones, so most portals are passed on only once.
  struct Entry {
    double distance = 0;
    std::uint32_t slot = 0;
    auto operator<=>(const Entry&) const = default;
  };

  std::uint32_t source_ = 0;
  std::vector<Slot> slots_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  Separators separators_;  // of the source and the portal that is passed on
};

}  // namespace temblor::compiler::vis
