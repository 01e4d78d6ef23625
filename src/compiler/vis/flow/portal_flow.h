// The search for what is seen through one portal: a depth-first walk through all chains of portals, each of
// which is cut to what straight lines from the first portal through the last one can reach.
//
//     source            pass           target
//       |                 |              :   <- cut off by the separators of source and pass
//       |  ------------>  |  --------->  |
//       |                 |              |
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

// Holds the working memory of one thread.
class PortalFlow {
 public:
  explicit PortalFlow(const PortalGraph& graph)
      : graph_(graph), reach_(graph), on_chain_(graph.portals.size(), 0) {}

  // Sets the bits (all 0 before) of the clusters that are seen through the portal. Returns false if `stop`
  // became true first. A search that takes too long is narrowed by Reach; what still might be seen through
  // portals that it has no time to try counts as seen: then too much is seen, never too little.
  // `shared_cuts`: 0, or the number of portals to cut, of which each portal of a chain gets a share; then
  // the search takes little time even in a crowded hall.
  bool run(std::uint32_t portal, const FlowBounds& bounds, std::size_t shared_cuts,
           const std::atomic<bool>& stop, std::span<BitMatrix::Word> io_seen);

 private:
  using Word = BitMatrix::Word;

  // One portal of the chain, and where lines through the chain up to it can pass.
  struct Link {
    std::uint32_t portal = 0;
    std::uint32_t next = 0, end = 0;  // the portals to try, those of the cluster beyond
    std::size_t cut_limit = 0;        // when this many portals were cut, the others are not tried
    Winding source, pass;             // the reachable parts of the chain's first portal and of this one
    std::vector<Word> might;          // clusters that might be seen beyond it
    Separators separators;            // of source and pass; none for the first
  };

  Link& link(std::size_t depth);
  void begin_link(std::uint32_t portal, std::size_t cut_limit, Link& out_link) const;
  bool extend(std::size_t depth, std::uint32_t portal, const FlowBounds& bounds, std::span<Word> io_seen);
  std::size_t share_cuts(const Link& from) const;
  void add_untried(const FlowBounds& bounds, Link& io_last, std::span<Word> io_seen) const;
  bool drop_hidden(Link& io_link, std::span<const Word> seen);
  bool cut_to_lines(Link& from, Link& io_to, bool direct);

  void tighten(std::uint32_t portal, std::size_t depth, const FlowBounds& bounds, std::span<Word> io_seen);

  const PortalGraph& graph_;
  Reach reach_;
  std::vector<Word> bound_;   // the result of reach_
  std::size_t cuts_ = 0;      // in this search
  bool shares_cuts_ = false;  // whether each portal of a chain gets a share of the cuts that are left
  std::deque<Link> chain_;    // a deque, so that references stay valid as it grows
  std::vector<std::uint8_t> on_chain_;  // by portal, 0 or 1
};

}  // namespace temblor::compiler::vis
