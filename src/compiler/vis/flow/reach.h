// A bound on what is seen through one portal, in time that does not grow with the number of ways through the
// level.
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

// The flow follows every chain of portals by itself, and between two places in a wide hall that the tree cut
// into cells there are more chains than can be counted. Here each portal is kept once, with the hull of what
// all chains reach of it, and is passed on again when that grows. Working memory of one thread.
class Reach {
 public:
  explicit Reach(const PortalGraph& graph) : graph_(graph), slot_of_portal_(graph.portals.size(), kNoSlot) {}

  // Sets the bits of all clusters of `might` that could be seen through the portal, some wrongly.
  void run(std::uint32_t portal, const FlowBounds& bounds, std::span<const BitMatrix::Word> might,
           std::span<BitMatrix::Word> out_bound);

 private:
  static constexpr std::uint32_t kNoSlot = 0xffffffff;

  struct Slot {
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
  std::deque<Slot> slots_;           // of the portals reached so far; references stay valid as it grows
  std::deque<std::uint32_t> queue_;  // slots to be passed on
};

}  // namespace temblor::compiler::vis
