// Which clusters of a level can see each other.
//
// Work is cut at portals, and a portal's result depends on the portals alone: not on threads, nor on who
// worked out which part. For that, portals are put in order of how much they might see and the order is cut
// into rounds; what a round finds narrows the search of all later rounds and of none of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/parallel_for.h"
#include "compiler/report.h"
#include "compiler/vis/bit_matrix.h"
#include "compiler/vis/portals.h"

namespace temblor::compiler {

namespace vis {
struct PortalGraph;
}

// The portals of a level, ready to be searched. Every portal of the set has clusters below its cluster_count
// and at least three corners (CHECKed).
class SearchablePortals {
 public:
  // Implicit: who asks once need not keep it.
  SearchablePortals(const PortalSet& portals);  // NOLINT(google-explicit-constructor)
  ~SearchablePortals();
  SearchablePortals(SearchablePortals&&) noexcept;
  SearchablePortals& operator=(SearchablePortals&&) noexcept;

  const vis::PortalGraph& graph() const { return *graph_; }
  std::uint64_t fingerprint() const { return fingerprint_; }

 private:
  std::unique_ptr<const vis::PortalGraph> graph_;
  std::uint64_t fingerprint_;
};

// How far the work is. Rows are portals in both directions, joined where the tree cut an opening for no
// reason that visibility has, so their number is not that of the PortalSet.
struct VisibilityState {
  std::uint64_t fingerprint = 0;       // of the PortalSet, and of the way in which rows are worked out
  BitMatrix seen;                      // clusters seen through each portal; 0 where it is not finished
  std::vector<std::uint8_t> finished;  // by portal, 0 or 1

  bool operator==(const VisibilityState&) const = default;
};

// One of several independent processes: 0 <= index < count.
struct WorkShare {
  std::uint32_t index = 0, count = 1;
};

enum class VisibilityEnd {
  kFinished,  // every row is known
  kStopped,   // because `progress` said so
  kWaiting,   // this share of the round is done; the next needs the other shares, merged into the state
};

// A state in which nothing is done.
VisibilityState begin_visibility(const SearchablePortals& portals);

// Goes on from a state of the same portals (CHECKed) to the end, or with a share of the work, to the end of
// its part of the first round that is not finished. `progress` counts units that time roughly follows.
VisibilityEnd continue_visibility(const SearchablePortals& portals, base::Jobs& jobs, Progress progress,
                                  VisibilityState& io_state, WorkShare share = {});

// Row and column: cluster; symmetric, and every cluster sees itself. What can be seen is never missing, but
// for openings that show as a slit narrower than 0.01 units. The state must be finished (CHECKed).
BitMatrix visible_clusters(const SearchablePortals& portals, const VisibilityState& state);

// The same from the sides of planes alone: at once, and far from tight.
BitMatrix roughly_visible_clusters(const SearchablePortals& portals, base::Jobs& jobs);

}  // namespace temblor::compiler
