// Visibility: which clusters of a level can see each other (the potentially visible set, or PVS).
//
// For each portal in each direction, a search (vis/flow/portal_flow.h) follows all chains of portals that a
// straight line can pass. The level's PVS joins the results of all portals of each cluster. The method is
// that of Teller, "Visibility Computations in Densely Occluded Polyhedral Environments" (1992), which Quake's
// vis uses, too.
//
// A portal's result depends only on the portals, not on threads or on how processes share the work. To that
// end, portals are sorted by how much they might see, and the order is cut into rounds. Results of a round
// narrow the searches of later rounds, but never those of the same round. In large halls, where most searches
// would not end, short searches in rounds before these compute bounds.
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

// The portals of a level, prepared for searching. Every portal's clusters are below cluster_count and it has
// at least three corners (CHECKed).
class SearchablePortals {
 public:
  // Implicit, so that callers with a single query can pass a PortalSet.
  SearchablePortals(const PortalSet& portals);  // NOLINT(google-explicit-constructor)
  ~SearchablePortals();
  SearchablePortals(SearchablePortals&&) noexcept;
  SearchablePortals& operator=(SearchablePortals&&) noexcept;

  const vis::PortalGraph& graph() const { return *graph_; }
  // A hash of the portals and of the version of the method.
  std::uint64_t fingerprint() const { return fingerprint_; }

 private:
  std::unique_ptr<const vis::PortalGraph> graph_;
  std::uint64_t fingerprint_;
};

// The results so far. Rows are directed portals after pieces of one opening were joined, so there
// are not twice as many as in the PortalSet.
struct VisibilityState {
  std::uint64_t fingerprint = 0;  // of the SearchablePortals
  // By portal: a bound of the clusters seen through it, from quick sweeps that each process would have to
  // repeat. No rows: not computed yet, or not needed.
  BitMatrix swept;
  // By crowded portal: a bound of the clusters seen through it, computed first; 0 if there is none yet.
  BitMatrix bound;
  std::vector<std::uint8_t> bounded;   // by portal, 0 or 1
  BitMatrix seen;                      // by portal: the clusters seen through it; 0 if it is not finished
  std::vector<std::uint8_t> finished;  // by portal, 0 or 1

  bool operator==(const VisibilityState&) const = default;
};

// The share of one of several independent processes: 0 <= index < count.
struct WorkShare {
  std::uint32_t index = 0, count = 1;
};

// Why continue_visibility() returned.
enum class VisibilityEnd {
  kFinished,  // every portal is finished
  kStopped,   // by `progress`
  kWaiting,   // this share of the round is done; the next round needs all shares merged into the state
};

// Returns a state in which nothing is done.
VisibilityState begin_visibility(const SearchablePortals& portals);

// Continues from a state of the same portals (CHECKed): to the end, or with a share, to the end of that share
// of the first unfinished round. `progress` counts units of roughly equal time. Only share 0 keeps the result
// of the sweeps, so that it is saved once.
VisibilityEnd continue_visibility(const SearchablePortals& portals, base::Jobs& jobs, Progress progress,
                                  VisibilityState& io_state, WorkShare share = {});

// Returns which clusters see each other: symmetric, and every cluster sees itself. It never misses anything
// visible, except through openings that appear as slits narrower than 0.01 units. The state must be finished
// (CHECKed).
BitMatrix find_visible_clusters(const SearchablePortals& portals, const VisibilityState& state);

// The same, quickly and far from tight: from the bound of vis/flow/base_visibility.h alone.
BitMatrix find_roughly_visible_clusters(const SearchablePortals& portals, base::Jobs& jobs);

}  // namespace temblor::compiler
