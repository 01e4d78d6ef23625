// What is seen through one portal: the flow through chains of portals, each cut to what straight lines from
// the first through the last can reach.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "compiler/bit_matrix.h"
#include "compiler/vis/portal_graph.h"
#include "compiler/vis/separators.h"

namespace temblor::compiler::vis {

// What might be seen through each portal, as far as the flow through another may know it: finished rows of
// the portals whose rank is below `finished`, base visibility for all others.
struct FlowBounds {
  const BitMatrix& base;
  const BitMatrix& seen;
  std::span<const std::uint32_t> rank_of_portal;
  std::uint32_t finished = 0;

  std::span<const BitMatrix::Word> row(std::uint32_t portal) const {
    return rank_of_portal[portal] < finished ? seen.row(portal) : base.row(portal);
  }
};

// Working memory of one thread.
class PortalFlow {
 public:
  explicit PortalFlow(const PortalGraph& graph) : graph_(graph), on_chain_(graph.portals.size() / 2, 0) {}

  // Sets the bits of the clusters that are seen through the portal. False when `stop` became true before the
  // end.
  bool run(std::uint32_t portal, const FlowBounds& bounds, const std::atomic<bool>& stop,
           std::span<BitMatrix::Word> io_seen);

 private:
  using Word = BitMatrix::Word;

  // The last portal of a chain, and where lines through the whole chain can pass.
  struct Link {
    std::uint32_t portal = 0;
    std::size_t next = 0;  // to try, among the portals out of the cluster beyond
    Winding source, pass;  // of the chain's first portal, of this one
    std::vector<Word> might;
    Separators separators;  // of source and pass; none for the first
  };

  Link& link(std::size_t depth);
  bool extend(std::size_t depth, std::uint32_t portal, const FlowBounds& bounds, std::span<Word> io_seen);
  bool drop_hidden(Link& io_link, std::span<const Word> seen);
  bool cut_to_lines(Link& from, Link& io_to, bool direct);

  const PortalGraph& graph_;
  std::deque<Link> chain_;              // the longest so far; references stay valid as it grows
  std::vector<std::uint8_t> on_chain_;  // by opening, 0 or 1
};

}  // namespace temblor::compiler::vis
