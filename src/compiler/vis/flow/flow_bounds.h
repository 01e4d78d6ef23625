// An upper bound of the view through each portal, which the searches narrow round by round.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/flow/portal_graph.h"

namespace temblor::compiler::vis {

// A row for each portal: the clusters that might be seen through it. Views of the rows from other sides are
// kept with them, so that searches find related bits in one place.
class FlowBounds {
 public:
  // `graph` must outlive this. Rows: portals; columns: clusters. `both_ways`: also drop what might not see
  // back. That is worth its time only in large halls.
  FlowBounds(const PortalGraph& graph, BitMatrix rows, bool both_ways);

  const BitMatrix& rows() const { return rows_; }
  std::span<const BitMatrix::Word> row(std::uint32_t portal) const { return rows_.row(portal); }
  // Whether a search from this cluster might enter the portal: not if the cluster might not be seen back
  // through the portal's reverse.
  bool may_see(std::size_t cluster, const DirectedPortal& portal) const {
    return !both_ways_ || has_bit(portals_seeing_.row(cluster), portal.reverse);
  }
  // Whether the view through the portal might include the i-th exit of the cluster beyond it.
  bool may_enter(std::uint32_t portal, std::uint32_t i) const {
    return i >= 64 || (open_exits_[portal] >> i & 1) != 0;
  }

  // Replaces the rows of some portals by those of `found`.
  void narrow(std::span<const std::uint32_t> portals, const BitMatrix& found);

 private:
  void keep_both_ways();
  void update_views();

  const PortalGraph& graph_;
  bool both_ways_;
  BitMatrix rows_;
  BitMatrix portals_seeing_;               // by cluster: the portals through which it might be seen
  std::vector<std::uint64_t> open_exits_;  // by portal
};

}  // namespace temblor::compiler::vis
