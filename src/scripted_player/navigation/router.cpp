#include "scripted_player/navigation/router.h"

#include <algorithm>

namespace temblor::player {
namespace {

constexpr float kUnreached = 1e9f;
// All in units of walking. A locked mover costs more than nearly any way around it. Waiting for a mover takes
// about as long as walking 120 units.
constexpr float kLockedCost = 6000, kWaitCost = 120, kDeadEndCost = 3000;

}  // namespace

Router::Router(const NavGraph& graph, const MoverWatch& movers)
    : graph_(&graph), movers_(&movers), is_goal_(graph.places().size()) {
  link_costs_.reserve(graph.link_count());
  first_links_.reserve(graph.places().size() + 1);
  for (const Place& place : graph.places()) {
    first_links_.push_back(static_cast<std::uint32_t>(link_costs_.size()));
    for (const Link& link : place.links)
      link_costs_.push_back({link.to, link.cost, link.conditions[0].mover >= 0});
  }
  first_links_.push_back(static_cast<std::uint32_t>(link_costs_.size()));
}

void Router::penalize_link(std::uint32_t from, std::uint32_t to, float cost) {
  last_penalized_ = {from, to};
  penalties_[*last_penalized_] += cost;
}

void Router::keep_last_penalty() {
  if (!last_penalized_) return;
  permanent_penalties_[*last_penalized_] += kDeadEndCost;
  penalties_[*last_penalized_] += kDeadEndCost;
  last_penalized_.reset();
}

// Returns the cost of a link as the movers are now; kUnreached if it cannot be used.
float Router::compute_cost(std::uint32_t from, const Link& link, const RouteRules& rules) const {
  float cost = link.cost;
  for (const MoverCondition& condition : link.conditions) {
    if (condition.mover < 0) continue;
    const auto& banned = rules.banned_movers;
    switch (movers_->access_any(condition.mover, condition.states)) {
      case Access::kNow:
        break;
      case Access::kAutomatic:
        cost += kWaitCost;
        break;
      case Access::kLocked:
        if (!rules.passes_locked || std::find(banned.begin(), banned.end(), condition.mover) != banned.end())
          return kUnreached;
        cost += kLockedCost;
        break;
      case Access::kNever:
        return kUnreached;
    }
  }
  if (const auto blamed = penalties_.find({from, link.to}); blamed != penalties_.end())
    cost += blamed->second;
  return cost;
}

bool Router::has_penalties(std::uint32_t from) const {
  const auto first = penalties_.lower_bound({from, 0});
  return first != penalties_.end() && first->first.first == from;
}

// Fills costs_ and came_by_. The heap may hold outdated entries of a place that was reached more cheaply
// later; they are skipped when they come up, which is simpler than decreasing keys in place.
void Router::search(std::uint32_t from, const RouteRules& rules) {
  costs_.assign(graph_->places().size(), kUnreached);
  came_by_.resize(costs_.size());
  has_reached_ = false;
  open_.clear();
  costs_[from] = 0;
  open_.push(0, from);
  while (!open_.is_empty()) {
    const auto [cost, at] = open_.pop();
    if (cost > costs_[at] || cost > rules.max_cost) continue;
    if (stops_at_goal_ && is_goal_[at]) {
      reached_goal_ = at;
      has_reached_ = true;
      return;
    }
    const bool is_penalized = has_penalties(at);
    const std::uint32_t first = first_links_[at];
    for (std::uint32_t i = first; i < first_links_[at + 1]; ++i) {
      // Most links lead to places that were reached more cheaply. Conditions and penalties only add to the
      // cost.
      const LinkCost& link = link_costs_[i];
      const std::uint32_t to = link.to;
      if (cost + link.cost >= costs_[to]) continue;
      const float link_cost = link.has_conditions || is_penalized
                                  ? compute_cost(at, graph_->place(at).links[i - first], rules)
                                  : link.cost;
      if (link_cost >= kUnreached || cost + link_cost >= costs_[to]) continue;
      costs_[to] = cost + link_cost;
      came_by_[to] = i;
      open_.push(cost + link_cost, to);
    }
  }
}

void Router::survey(std::uint32_t from) {
  search(from, {});
  surveyed_costs_ = costs_;
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
  return trace_back(surveyed_start_, best, surveyed_costs_, surveyed_by_);
}

// Follows the links from the goal back to the start, then reverses the result.
Route Router::trace_back(std::uint32_t from, std::uint32_t to, std::span<const float> costs,
                         std::span<const std::uint32_t> came_by) const {
  Route route;
  route.cost = costs[to];
  for (std::uint32_t at = to; at != from;) {
    const std::uint32_t link = came_by[at];
    route.places.push_back(at);
    // The place whose links include this one.
    at = static_cast<std::uint32_t>(std::upper_bound(first_links_.begin(), first_links_.end(), link) -
                                    first_links_.begin() - 1);
    route.links.push_back(graph_->place(at).links[link - first_links_[at]]);
  }
  route.places.push_back(from);
  std::reverse(route.places.begin(), route.places.end());
  std::reverse(route.links.begin(), route.links.end());
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
  Route route = trace_back(from, reached_goal_, costs_, came_by_);
  // The planner opens the first locked mover, because the player meets it first.
  for (const Link& link : route.links)
    for (const MoverCondition& condition : link.conditions)
      if (route.locked_mover < 0 && condition.mover >= 0 &&
          movers_->access_any(condition.mover, condition.states) == Access::kLocked)
        route.locked_mover = condition.mover;
  return route;
}

// Scans all places. This is only for messages about a goal that cannot be reached.
std::optional<math::Vec3> Router::find_nearest_reached(const math::Bounds& box) const {
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

std::span<const float> Router::compute_costs(std::uint32_t from, const RouteRules& rules) {
  search(from, rules);
  return costs_;
}

}  // namespace temblor::player
