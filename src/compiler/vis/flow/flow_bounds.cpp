#include "compiler/vis/flow/flow_bounds.h"

#include <algorithm>
#include <utility>

namespace temblor::compiler::vis {

FlowBounds::FlowBounds(const PortalGraph& graph, BitMatrix rows, bool both_ways)
    : graph_(graph), both_ways_(both_ways), rows_(std::move(rows)) {
  update_views();
}

void FlowBounds::narrow(std::span<const std::uint32_t> portals, const BitMatrix& found) {
  for (const std::uint32_t portal : portals) std::ranges::copy(found.row(portal), rows_.row(portal).begin());
  if (both_ways_) keep_both_ways();
  update_views();
}

// Drops clusters from which no portal might see back.
void FlowBounds::keep_both_ways() {
  BitMatrix seen_by(graph_.cluster_count, graph_.cluster_count);
  for (std::uint32_t i = 0; i < graph_.portals.size(); ++i)
    add_bits(rows_.row(i), seen_by.row(graph_.portals[i].from));
  const BitMatrix seen_from = transpose(seen_by);
  for (std::uint32_t i = 0; i < graph_.portals.size(); ++i) {
    keep_bits(seen_from.row(graph_.portals[i].from), rows_.row(i));
    set_bit(rows_.row(i), graph_.portals[i].to);
  }
}

void FlowBounds::update_views() {
  if (both_ways_) portals_seeing_ = transpose(rows_);
  open_exits_.assign(graph_.portals.size(), 0);
  for (std::uint32_t i = 0; i < graph_.portals.size(); ++i) {
    const std::uint32_t cluster = graph_.portals[i].to, first = graph_.first_exit[cluster];
    const std::uint32_t count = std::min(graph_.first_exit[cluster + 1] - first, 64u);
    for (std::uint32_t k = 0; k < count; ++k) {
      const DirectedPortal& exit = graph_.portals[first + k];
      if (first + k != graph_.portals[i].reverse && has_bit(rows_.row(i), exit.to))
        open_exits_[i] |= std::uint64_t{1} << k;
    }
  }
}

}  // namespace temblor::compiler::vis
