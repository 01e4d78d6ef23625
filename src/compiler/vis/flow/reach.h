// A bound on what is seen through one portal, in time that does not grow with the number of chains of
// portals.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/flow/flow_bounds.h"
#include "compiler/vis/flow/portal_graph.h"
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

  struct Slot {
    // A portal that has been reached.
    std::uint32_t portal = 0;
    Winding reached;
    int growths = 0;
    bool queued = false;
  };

  void pass_on(const DirectedPortal& source, const Slot& from, const FlowBounds& bounds,
               std::span<const BitMatrix::Word> might, std::span<BitMatrix::Word> io_bound);
  void reach(std::uint32_t portal, const Winding& piece);

  const PortalGraph& graph_;
  std::vector<std::uint32_t> slot_of_portal_;
  std::deque<Slot> slots_;           // a deque, so that references stay valid as it grows
  std::deque<std::uint32_t> queue_;  // indices of the slots whose hull has grown
};

}  // namespace temblor::compiler::vis
