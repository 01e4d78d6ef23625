// What is seen through one portal: the flow through chains of portals, each cut to what straight lines from
// the first through the last can reach.
#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/flow/flow_bounds.h"
#include "compiler/vis/flow/portal_graph.h"
#include "compiler/vis/flow/reach.h"
#include "compiler/vis/flow/separators.h"

namespace temblor::compiler::vis {

// Working memory of one thread.
class PortalFlow {
 public:
  explicit PortalFlow(const PortalGraph& graph)
      : graph_(graph), reach_(graph), on_chain_(graph.portals.size() / 2, 0) {}

  // Sets the bits (all 0 before) of the clusters that are seen through the portal. False when `stop` became
  // true before the end. A search that takes too long is bounded by Reach, and if that does not end it soon,
  // replaced by it: then more is seen, never less.
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

  void tighten(std::uint32_t portal, std::size_t depth, const FlowBounds& bounds, std::span<Word> io_seen);

  const PortalGraph& graph_;
  Reach reach_;
  std::vector<Word> bound_;             // from reach_
  std::size_t cuts_ = 0;                // portals cut so far in this search
  std::deque<Link> chain_;              // the longest so far; references stay valid as it grows
  std::vector<std::uint8_t> on_chain_;  // by opening, 0 or 1
};

}  // namespace temblor::compiler::vis
