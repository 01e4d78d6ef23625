// Method: Dijkstra's (1959), with a binary heap.
#include "scripted_player/navigation/router.h"

#include <algorithm>
#include <queue>

namespace temblor::player {
namespace {

constexpr float kUnreached = 1e9f;
constexpr float kLockedCost = 6000, kWaitCost = 120, kDeadEndCost = 3000;

}  // namespace

Router::Router(const NavGraph& graph, const MoverWatch& movers)
    : graph_(&graph), movers_(&movers), is_goal_(graph.places().size()) {}

void Router::blame(std::uint32_t from, std::uint32_t to, float cost) {
  last_blamed_ = {from, to};
  blamed_[*last_blamed_] += cost;
}

void Router::keep_last_blame() {
  if (!last_blamed_) return;
  kept_[*last_blamed_] += kDeadEndCost;
  blamed_[*last_blamed_] += kDeadEndCost;
  last_blamed_.reset();
}

float Router::cost_of(std::uint32_t from, const Way& way, const RouteRules& rules, bool& out_locked) const {
  float cost = way.cost;
  if (way.demands[0].mover < 0 && blamed_.empty()) return cost;
  for (const Demand& demand : way.demands) {
    if (demand.mover < 0) continue;
    const auto& banned = rules.banned_movers;
    switch (movers_->access_any(demand.mover, demand.states)) {
      case Access::kNow:
        break;
      case Access::kSelf:
        cost += kWaitCost;
        break;
      case Access::kLocked:
        if (!rules.passes_locked || std::find(banned.begin(), banned.end(), demand.mover) != banned.end())
          return kUnreached;
        out_locked = true;
        cost += kLockedCost;
        break;
      case Access::kNever:
        return kUnreached;
    }
  }
  if (!blamed_.empty())
    if (const auto blamed = blamed_.find({from, way.to}); blamed != blamed_.end()) cost += blamed->second;
  return cost;
}

void Router::search(std::uint32_t from, const RouteRules& rules) {
  const std::size_t count = graph_->places().size();
  costs_.assign(count, kUnreached);
  came_from_.assign(count, 0);
  came_by_.assign(count, 0);
  has_reached_ = false;
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  costs_[from] = 0;
  open.push({0, from});
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost > costs_[at] || cost > rules.most_cost) continue;
    if (stops_at_goal_ && is_goal_[at]) {
      reached_goal_ = at;
      has_reached_ = true;
      return;
    }
    const std::vector<Way>& ways = graph_->place(at).ways;
    for (std::uint32_t i = 0; i < ways.size(); ++i) {
      bool locked = false;
      const float way_cost = cost_of(at, ways[i], rules, locked);
      if (way_cost >= kUnreached || cost + way_cost >= costs_[ways[i].to]) continue;
      costs_[ways[i].to] = cost + way_cost;
      came_from_[ways[i].to] = at;
      came_by_[ways[i].to] = i;
      open.push({cost + way_cost, ways[i].to});
    }
  }
}

void Router::survey(std::uint32_t from) {
  search(from, {});
  surveyed_costs_ = costs_;
  surveyed_from_ = came_from_;
  surveyed_by_ = came_by_;
  surveyed_start_ = from;
}

std::optional<Route> Router::find_surveyed(std::span<const std::uint32_t> goals) const {
  std::uint32_t best = 0;
  float best_cost = kUnreached;
  for (const std::uint32_t goal : goals) {
    if (surveyed_costs_[goal] >= best_cost) continue;
    best_cost = surveyed_costs_[goal];
    best = goal;
  }
  if (best_cost >= kUnreached) return std::nullopt;
  return trace_back(surveyed_start_, best, surveyed_costs_, surveyed_from_, surveyed_by_);
}

Route Router::trace_back(std::uint32_t from, std::uint32_t to, std::span<const float> costs,
                         std::span<const std::uint32_t> came_from,
                         std::span<const std::uint32_t> came_by) const {
  Route route;
  route.cost = costs[to];
  for (std::uint32_t at = to; at != from; at = came_from[at]) {
    route.places.push_back(at);
    route.ways.push_back(graph_->place(came_from[at]).ways[came_by[at]]);
  }
  route.places.push_back(from);
  std::reverse(route.places.begin(), route.places.end());
  std::reverse(route.ways.begin(), route.ways.end());
  return route;
}

std::optional<Route> Router::find(std::uint32_t from, std::span<const std::uint32_t> goals,
                                  const RouteRules& rules) {
  if (goals.empty()) return std::nullopt;
  for (const std::uint32_t goal : goals) is_goal_[goal] = true;
  stops_at_goal_ = true;
  search(from, rules);
  stops_at_goal_ = false;
  for (const std::uint32_t goal : goals) is_goal_[goal] = false;
  if (!has_reached_) return std::nullopt;
  Route route = trace_back(from, reached_goal_, costs_, came_from_, came_by_);
  for (const Way& way : route.ways)
    for (const Demand& demand : way.demands)
      if (route.locked_mover < 0 && demand.mover >= 0 &&
          movers_->access_any(demand.mover, demand.states) == Access::kLocked)
        route.locked_mover = demand.mover;
  return route;
}

std::optional<math::Vec3> Router::nearest_reached(const math::Bounds& box) const {
  std::optional<math::Vec3> best;
  float best_distance = kUnreached;
  for (std::size_t i = 0; i < costs_.size(); ++i) {
    if (costs_[i] >= kUnreached) continue;
    const math::Vec3& at = graph_->places()[i].at;
    const float distance = glm::distance(at, glm::clamp(at, box.mins, box.maxs));
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = at;
  }
  return best;
}

std::span<const float> Router::costs_from(std::uint32_t from, const RouteRules& rules) {
  search(from, rules);
  return costs_;
}

}  // namespace temblor::player
