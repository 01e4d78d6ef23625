// Rounds: portals in the order of what they might see, cut at fixed percentages.
//
//   cheap portals                                          expensive portals
//   |------ round 1 ------|--- round 2 ---|-- round 3 --|- 4 -|- 5 -|- 6 -|- 7 -|
//    base visibility only   uses the rows    uses the rows of rounds 1 and 2 ...
//                           of round 1
#include "compiler/vis/visibility.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <memory>
#include <mutex>
#include <numeric>
#include <span>

#include "base/check.h"
#include "base/hash.h"
#include "compiler/vis/flow/base_visibility.h"
#include "compiler/vis/flow/portal_flow.h"
#include "compiler/vis/flow/portal_graph.h"

namespace temblor::compiler {

namespace {

using vis::PortalGraph;

// Raise this if the same portals get other rows, so that no saved state is continued by another method.
constexpr std::uint64_t kMethod = 1;

// Where rounds end, in percent of the portals. The first portals are quick and the last ones slow, so rounds
// get shorter. With more rounds, a run waits more often for its slowest thread and gains little.
constexpr std::array<std::size_t, 7> kRoundEnds{40, 60, 75, 85, 92, 97, 100};

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
  std::vector<std::uint32_t> portals, rank_of_portal;
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
  order.rank_of_portal.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t might_see = count_bits(base_visibility.row(i));
    order.cost_of_portal.push_back(might_see * might_see);
  }
  std::iota(order.portals.begin(), order.portals.end(), 0u);
  std::ranges::stable_sort(order.portals, {},
                           [&](std::uint32_t portal) { return order.cost_of_portal[portal]; });
  for (std::size_t i = 0; i < count; ++i)
    order.rank_of_portal[order.portals[i]] = static_cast<std::uint32_t>(i);
  return order;
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

// Working memory, lent to one job at a time.
class FlowPool {
 public:
  explicit FlowPool(const PortalGraph& graph) : graph_(graph) {}

  std::unique_ptr<vis::PortalFlow> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<vis::PortalFlow>(graph_);
    auto flow = std::move(idle_.back());
    idle_.pop_back();
    return flow;
  }
  void give_back(std::unique_ptr<vis::PortalFlow> flow) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(flow));
  }

 private:
  const PortalGraph& graph_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<vis::PortalFlow>> idle_;
};

// Computes the rows of some portals of one round.
void run_portals(std::span<const std::uint32_t> portals, const WorkOrder& order,
                 const vis::FlowBounds& bounds, base::Jobs& jobs, FlowPool& io_pool, FlowMeter& io_meter,
                 VisibilityState& io_state) {
  // Short searches are grouped, so that threads seldom wait for each other.
  constexpr std::size_t kBatches = 256;
  const std::size_t batch_size = std::max<std::size_t>(1, portals.size() / kBatches);
  jobs.parallel_for((portals.size() + batch_size - 1) / batch_size, [&](std::size_t batch) {
    auto flow = io_pool.take();
    std::uint64_t done = 0;
    const std::size_t end = std::min((batch + 1) * batch_size, portals.size());
    for (std::size_t i = batch * batch_size; i < end && !io_meter.stopped(); ++i) {
      // The longest searches come first, so that no thread is left with one at the end of the round.
      const std::uint32_t portal = portals[portals.size() - 1 - i];
      const auto row = io_state.seen.row(portal);
      if (flow->run(portal, bounds, io_meter.stopped(), row)) {
        io_state.finished[portal] = 1;
        done += order.cost_of_portal[portal];
      } else {
        std::ranges::fill(row, BitMatrix::Word{0});
      }
    }
    io_pool.give_back(std::move(flow));
    io_meter.add(done);
  });
}

// Keeps the pairs that see each other: each search may exclude what the other could not.
BitMatrix keep_mutual(const BitMatrix& matrix) {
  BitMatrix mutual(matrix.rows(), matrix.columns());
  for (std::size_t a = 0; a < matrix.rows(); ++a) {
    const auto row = matrix.row(a);
    for (std::size_t i = 0; i < row.size(); ++i) {
      for (BitMatrix::Word rest = row[i]; rest != 0; rest &= rest - 1) {
        const std::size_t b = i * 64 + static_cast<std::size_t>(std::countr_zero(rest));
        if (matrix.at(b, a)) mutual.set(a, b);
      }
    }
  }
  return mutual;
}

// A cluster sees what is seen through any of its portals, and itself.
BitMatrix join_portals(const PortalGraph& graph, const BitMatrix& seen_by_portal) {
  BitMatrix joined(graph.cluster_count, graph.cluster_count);
  for (std::size_t i = 0; i < graph.cluster_count; ++i) joined.set(i, i);
  for (std::size_t i = 0; i < graph.portals.size(); ++i) {
    const auto from = seen_by_portal.row(i);
    const auto to = joined.row(graph.portals[i].from);
    for (std::size_t word = 0; word < to.size(); ++word) to[word] |= from[word];
  }
  return keep_mutual(joined);
}

bool matches(const VisibilityState& state, const SearchablePortals& portals) {
  const PortalGraph& graph = portals.graph();
  return state.fingerprint == portals.fingerprint() && state.finished.size() == graph.portals.size() &&
         state.seen.rows() == graph.portals.size() && state.seen.columns() == graph.cluster_count;
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
  return {portals.fingerprint(), BitMatrix(graph.portals.size(), graph.cluster_count),
          std::vector<std::uint8_t>(graph.portals.size(), 0)};
}

VisibilityEnd continue_visibility(const SearchablePortals& portals, base::Jobs& jobs, Progress progress,
                                  VisibilityState& io_state, WorkShare share) {
  CHECK(share.index < share.count);
  const PortalGraph& graph = portals.graph();
  CHECK(matches(io_state, portals));
  const BitMatrix base_visibility = vis::find_base_visibility(graph, jobs);
  const WorkOrder order = order_portals(base_visibility);

  std::vector<std::uint32_t> known = order.portals;
  std::erase_if(known, [&](std::uint32_t portal) { return io_state.finished[portal] == 0; });
  FlowMeter meter(progress, order.cost(known), order.cost(order.portals));
  FlowPool pool(graph);
  std::uint32_t round_begin = 0;
  for (const std::size_t end_percent : kRoundEnds) {
    const auto round_end = static_cast<std::uint32_t>(order.portals.size() * end_percent / 100);
    std::vector<std::uint32_t> round, own;
    for (std::uint32_t rank = round_begin; rank < round_end; ++rank) {
      const std::uint32_t portal = order.portals[rank];
      if (io_state.finished[portal] != 0) continue;
      round.push_back(portal);
      if (rank % share.count == share.index) own.push_back(portal);
    }
    const vis::FlowBounds bounds{base_visibility, io_state.seen, order.rank_of_portal, round_begin};
    run_portals(own, order, bounds, jobs, pool, meter, io_state);
    if (meter.stopped()) return VisibilityEnd::kStopped;
    if (own.size() < round.size()) return VisibilityEnd::kWaiting;
    round_begin = round_end;
  }
  return VisibilityEnd::kFinished;
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
