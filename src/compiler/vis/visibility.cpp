// Rounds: portals in the order of what they might see, cut at fixed percentages.
//
//   cheap portals                                          expensive portals
//   |------ round 1 ------|--- round 2 ---|-- round 3 --|- 4 -|- 5 -|- 6 -|- 7 -|
//    base visibility only   uses the rows    uses the rows of rounds 1 and 2 ...
//                           of round 1
//
// Crowded portals get bounds in rounds of their own, before these, and quick sweeps come first.
#include "compiler/vis/visibility.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <memory>
#include <mutex>
#include <numeric>
#include <span>
#include <utility>

#include "base/check.h"
#include "base/hash.h"
#include "compiler/vis/flow/base_visibility.h"
#include "compiler/vis/flow/flow_bounds.h"
#include "compiler/vis/flow/portal_flow.h"
#include "compiler/vis/flow/portal_graph.h"

namespace temblor::compiler {

namespace {

using vis::PortalGraph;

// Raise this if the same portals get other rows, so that no saved state is continued by another method.
constexpr std::uint64_t kMethod = 4;

// Where rounds end, in percent of the portals. The first portals are quick and the last ones slow, so rounds
// get shorter. With more rounds, a run waits more often for its slowest thread and gains little.
constexpr std::array<std::size_t, 7> kRoundEnds{40, 60, 75, 85, 92, 97, 100};

// A portal that might see more clusters than this is crowded. Few portals of ordinary levels are.
constexpr std::size_t kCrowdedClusters = 512;

// Portals that a crowded portal's searches cut: first in sweeps over all portals, then for its bound, and for
// its row. A search with more cuts takes hardly more time if the bounds are narrow.
constexpr std::array<std::size_t, 2> kSweepCuts{300, 3000};
constexpr std::size_t kCrowdedBoundCuts = 30'000, kCrowdedRowCuts = 100'000;

// Depends on every number of every portal, in order.
std::uint64_t compute_fingerprint(const PortalSet& set) {
  std::uint64_t hash = base::hash_with(kMethod, set.cluster_count);
  const auto add = [&hash](double value) {
    hash = base::hash_with(hash, std::bit_cast<std::uint64_t>(value + 0.0));
  };
  for (const Portal& portal : set.portals) {
    hash = base::hash_with(hash, portal.clusters[0]);
    hash = base::hash_with(hash, portal.clusters[1]);
    hash = base::hash_with(hash, portal.winding_world.size());
    for (const math::Vec3d& corner : portal.winding_world)
      for (int axis = 0; axis < 3; ++axis) add(corner[axis]);
    for (int axis = 0; axis < 3; ++axis) add(portal.normal[axis]);
    add(portal.distance);
  }
  return hash;
}

// Portals in the order of the work: those that might see least come first.
struct WorkOrder {
  std::vector<std::uint32_t> portals;
  std::vector<std::uint64_t> cost_of_portal;  // roughly proportional to its time

  std::uint64_t cost(std::span<const std::uint32_t> some) const {
    return std::accumulate(
        some.begin(), some.end(), std::uint64_t{0},
        [&](std::uint64_t sum, std::uint32_t portal) { return sum + cost_of_portal[portal]; });
  }
};

WorkOrder order_portals(const BitMatrix& base_visibility) {
  const std::size_t count = base_visibility.rows();
  WorkOrder order;
  order.portals.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t might_see = count_bits(base_visibility.row(i));
    order.cost_of_portal.push_back(might_see * might_see);
  }
  std::iota(order.portals.begin(), order.portals.end(), 0u);
  return order;
}

// Sorts by how much the portals might see. Costs stay those of base visibility, so that progress is even.
void sort_by_bound(const BitMatrix& bound, std::vector<std::uint32_t>& io_portals) {
  std::vector<std::size_t> might_see;
  for (std::size_t i = 0; i < bound.rows(); ++i) might_see.push_back(count_bits(bound.row(i)));
  std::ranges::stable_sort(io_portals, {}, [&](std::uint32_t portal) { return might_see[portal]; });
}

// 1 for each crowded portal.
std::vector<std::uint8_t> find_crowded(const BitMatrix& base_visibility) {
  std::vector<std::uint8_t> crowded;
  for (std::size_t i = 0; i < base_visibility.rows(); ++i)
    crowded.push_back(count_bits(base_visibility.row(i)) > kCrowdedClusters ? 1 : 0);
  return crowded;
}

// Reports progress to the caller, from any thread.
class FlowMeter {
 public:
  FlowMeter(Progress progress, std::uint64_t done, std::uint64_t total)
      : progress_(progress), done_(done), total_(total) {
    add(0);
  }

  void add(std::uint64_t cost) {
    const std::lock_guard lock(mutex_);
    done_ += cost;
    if (!stopped_ && !progress_(done_, total_)) stopped_ = true;
  }
  const std::atomic<bool>& stopped() const { return stopped_; }

 private:
  std::mutex mutex_;
  Progress progress_;
  std::uint64_t done_, total_;
  std::atomic<bool> stopped_{false};
};

// Working memory of searches, lent to one job at a time.
template <typename Search>
class SearchPool {
 public:
  explicit SearchPool(const PortalGraph& graph) : graph_(graph) {}

  std::unique_ptr<Search> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<Search>(graph_);
    auto search = std::move(idle_.back());
    idle_.pop_back();
    return search;
  }
  void give_back(std::unique_ptr<Search> search) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(search));
  }

 private:
  const PortalGraph& graph_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Search>> idle_;
};

// Runs one search for each portal; run(search, portal) returns false if it was stopped.
template <typename Search, typename Run>
void run_searches(std::span<const std::uint32_t> portals, const WorkOrder& order, base::Jobs& jobs,
                  SearchPool<Search>& io_pool, FlowMeter& io_meter, const Run& run) {
  // Short searches are grouped, so that threads seldom wait for each other.
  constexpr std::size_t kBatches = 256;
  const std::size_t batch_size = std::max<std::size_t>(1, portals.size() / kBatches);
  jobs.parallel_for((portals.size() + batch_size - 1) / batch_size, [&](std::size_t batch) {
    auto search = io_pool.take();
    std::uint64_t done = 0;
    const std::size_t end = std::min((batch + 1) * batch_size, portals.size());
    for (std::size_t i = batch * batch_size; i < end && !io_meter.stopped(); ++i) {
      // The longest searches come first, so that no thread is left with one at the end of the round.
      const std::uint32_t portal = portals[portals.size() - 1 - i];
      if (run(*search, portal)) done += order.cost_of_portal[portal];
    }
    io_pool.give_back(std::move(search));
    io_meter.add(done);
  });
}

// The portals of a round that are not done, and this process' part of them.
struct RoundWork {
  std::vector<std::uint32_t> open, own;
};
RoundWork divide_round(std::span<const std::uint32_t> portals, std::size_t first_rank,
                       std::span<const std::uint8_t> done, WorkShare share) {
  RoundWork work;
  for (std::size_t i = 0; i < portals.size(); ++i) {
    if (done[portals[i]] != 0) continue;
    work.open.push_back(portals[i]);
    if ((first_rank + i) % share.count == share.index) work.own.push_back(portals[i]);
  }
  return work;
}

// Runs searches of some portals in rounds, and narrows the bounds by the results of each. run() gets the
// portals of this share of a round, and sets their `done` and the rows of `found`.
template <typename Run>
VisibilityEnd run_rounds(std::span<const std::uint32_t> portals, std::span<const std::uint8_t> done,
                         const BitMatrix& found, WorkShare share, const FlowMeter& meter,
                         vis::FlowBounds& io_bounds, const Run& run) {
  std::size_t begin = 0;
  for (const std::size_t end_percent : kRoundEnds) {
    const std::size_t end = portals.size() * end_percent / 100;
    const auto round = portals.subspan(begin, end - begin);
    const RoundWork work = divide_round(round, begin, done, share);
    run(work.own);
    if (meter.stopped()) return VisibilityEnd::kStopped;
    if (work.own.size() < work.open.size()) return VisibilityEnd::kWaiting;
    if (!round.empty()) io_bounds.narrow(round, found);
    begin = end;
  }
  return VisibilityEnd::kFinished;
}

using FlowPool = SearchPool<vis::PortalFlow>;

// A sweep takes about this part of the time of the searches for rows.
constexpr std::uint64_t kSweepsPerSearch = 4;

// Narrows the bounds of all portals by short searches. `order` has the costs of one sweep. Returns false if
// it was stopped.
bool sweep(std::size_t cuts, const WorkOrder& order, base::Jobs& jobs, FlowPool& io_pool, FlowMeter& io_meter,
           vis::FlowBounds& io_bounds) {
  BitMatrix found(io_bounds.rows().rows(), io_bounds.rows().columns());
  std::vector<std::uint32_t> portals = order.portals;
  sort_by_bound(io_bounds.rows(), portals);
  std::size_t begin = 0;
  for (const std::size_t end_percent : kRoundEnds) {
    const std::size_t end = portals.size() * end_percent / 100;
    const auto round = std::span(portals).subspan(begin, end - begin);
    run_searches(round, order, jobs, io_pool, io_meter, [&](vis::PortalFlow& flow, std::uint32_t portal) {
      return flow.run(portal, io_bounds, cuts, io_meter.stopped(), found.row(portal));
    });
    if (io_meter.stopped()) return false;
    io_bounds.narrow(round, found);
    begin = end;
  }
  return true;
}

// Runs all sweeps. Returns false if it was stopped.
bool run_sweeps(const WorkOrder& order, base::Jobs& jobs, FlowPool& io_pool, FlowMeter& io_meter,
                vis::FlowBounds& io_bounds) {
  return std::ranges::all_of(
      kSweepCuts, [&](std::size_t cuts) { return sweep(cuts, order, jobs, io_pool, io_meter, io_bounds); });
}

// Computes the bounds of some crowded portals of one round.
void run_bounds(std::span<const std::uint32_t> portals, const WorkOrder& order, const vis::FlowBounds& bounds,
                base::Jobs& jobs, FlowPool& io_pool, FlowMeter& io_meter, VisibilityState& io_state) {
  run_searches(portals, order, jobs, io_pool, io_meter, [&](vis::PortalFlow& flow, std::uint32_t portal) {
    const auto row = io_state.bound.row(portal);
    if (flow.run(portal, bounds, kCrowdedBoundCuts, io_meter.stopped(), row)) {
      io_state.bounded[portal] = 1;
      return true;
    }
    std::ranges::fill(row, BitMatrix::Word{0});
    return false;
  });
}

// The bounds and crowded portals that the searches of one round use.
struct FlowInput {
  const vis::FlowBounds& bounds;
  std::span<const std::uint8_t> is_crowded;
};

// Computes the rows of some portals of one round.
void run_flows(std::span<const std::uint32_t> portals, const WorkOrder& order, const FlowInput& input,
               base::Jobs& jobs, FlowPool& io_pool, FlowMeter& io_meter, VisibilityState& io_state) {
  run_searches(portals, order, jobs, io_pool, io_meter, [&](vis::PortalFlow& flow, std::uint32_t portal) {
    const auto row = io_state.seen.row(portal);
    const std::size_t cuts = input.is_crowded[portal] != 0 ? kCrowdedRowCuts : 0;
    if (flow.run(portal, input.bounds, cuts, io_meter.stopped(), row)) {
      io_state.finished[portal] = 1;
      return true;
    }
    std::ranges::fill(row, BitMatrix::Word{0});
    return false;
  });
}

// Keeps the pairs that see each other: each search may exclude what the other could not.
BitMatrix keep_mutual(BitMatrix matrix) {
  const BitMatrix transposed = transpose(matrix);
  for (std::size_t a = 0; a < matrix.rows(); ++a) keep_bits(transposed.row(a), matrix.row(a));
  return matrix;
}

// A cluster sees what is seen through any of its portals, and itself.
BitMatrix join_portals(const PortalGraph& graph, const BitMatrix& seen_by_portal) {
  BitMatrix joined(graph.cluster_count, graph.cluster_count);
  for (std::size_t i = 0; i < graph.cluster_count; ++i) joined.set(i, i);
  for (std::size_t i = 0; i < graph.portals.size(); ++i)
    add_bits(seen_by_portal.row(i), joined.row(graph.portals[i].from));
  return keep_mutual(std::move(joined));
}

bool matches(const VisibilityState& state, const SearchablePortals& portals) {
  const PortalGraph& graph = portals.graph();
  return state.fingerprint == portals.fingerprint() && state.finished.size() == graph.portals.size() &&
         (state.swept.rows() == 0 ||
          (state.swept.rows() == graph.portals.size() && state.swept.columns() == graph.cluster_count)) &&
         state.bounded.size() == graph.portals.size() && state.bound.rows() == graph.portals.size() &&
         state.bound.columns() == graph.cluster_count && state.seen.rows() == graph.portals.size() &&
         state.seen.columns() == graph.cluster_count;
}

}  // namespace

SearchablePortals::SearchablePortals(const PortalSet& portals)
    : graph_(std::make_unique<PortalGraph>(vis::make_portal_graph(portals))),
      fingerprint_(compute_fingerprint(portals)) {}
SearchablePortals::~SearchablePortals() = default;
SearchablePortals::SearchablePortals(SearchablePortals&&) noexcept = default;
SearchablePortals& SearchablePortals::operator=(SearchablePortals&&) noexcept = default;

VisibilityState begin_visibility(const SearchablePortals& portals) {
  const PortalGraph& graph = portals.graph();
  const BitMatrix none(graph.portals.size(), graph.cluster_count);
  const std::vector<std::uint8_t> no_portal(graph.portals.size(), 0);
  return {portals.fingerprint(), {}, none, no_portal, none, no_portal};
}

VisibilityEnd continue_visibility(const SearchablePortals& portals, base::Jobs& jobs, Progress progress,
                                  VisibilityState& io_state, WorkShare share) {
  CHECK(share.index < share.count);
  const PortalGraph& graph = portals.graph();
  CHECK(matches(io_state, portals));
  BitMatrix base_visibility = vis::find_base_visibility(graph, jobs);
  WorkOrder order = order_portals(base_visibility);
  const std::vector<std::uint8_t> is_crowded = find_crowded(base_visibility);
  const auto list_portals = [&](std::span<const std::uint8_t> flags) {
    std::vector<std::uint32_t> portals_with_flag = order.portals;
    std::erase_if(portals_with_flag, [&](std::uint32_t portal) { return flags[portal] == 0; });
    return portals_with_flag;
  };
  std::vector<std::uint32_t> crowded = list_portals(is_crowded);
  sort_by_bound(base_visibility, crowded);
  WorkOrder sweeps = order;
  for (std::uint64_t& cost : sweeps.cost_of_portal) cost /= kSweepsPerSearch;
  const bool is_swept = crowded.empty() || io_state.swept.rows() != 0;
  const std::uint64_t sweep_cost = crowded.empty() ? 0 : sweeps.cost(sweeps.portals) * kSweepCuts.size();
  FlowMeter meter(progress,
                  (is_swept ? sweep_cost : 0) + order.cost(list_portals(io_state.bounded)) +
                      order.cost(list_portals(io_state.finished)),
                  sweep_cost + order.cost(crowded) + order.cost(order.portals));

  FlowPool flows(graph);
  vis::FlowBounds bounds(graph, io_state.swept.rows() != 0 ? io_state.swept : std::move(base_visibility),
                         !crowded.empty());
  if (!is_swept) {
    if (!run_sweeps(sweeps, jobs, flows, meter, bounds)) return VisibilityEnd::kStopped;
    if (share.index == 0) io_state.swept = bounds.rows();
  }
  const VisibilityEnd bounded =
      run_rounds(crowded, io_state.bounded, io_state.bound, share, meter, bounds,
                 [&](auto own) { run_bounds(own, order, bounds, jobs, flows, meter, io_state); });
  if (bounded != VisibilityEnd::kFinished) return bounded;
  sort_by_bound(bounds.rows(), order.portals);
  return run_rounds(order.portals, io_state.finished, io_state.seen, share, meter, bounds, [&](auto own) {
    run_flows(own, order, {bounds, is_crowded}, jobs, flows, meter, io_state);
  });
}

BitMatrix find_visible_clusters(const SearchablePortals& portals, const VisibilityState& state) {
  const PortalGraph& graph = portals.graph();
  CHECK(matches(state, portals));
  CHECK(std::ranges::find(state.finished, 0) == state.finished.end());
  return join_portals(graph, state.seen);
}

BitMatrix find_roughly_visible_clusters(const SearchablePortals& portals, base::Jobs& jobs) {
  const PortalGraph& graph = portals.graph();
  return join_portals(graph, vis::find_base_visibility(graph, jobs));
}

}  // namespace temblor::compiler
