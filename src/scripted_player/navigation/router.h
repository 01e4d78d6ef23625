// Finds the cheapest route through the graph of a level, for the current states of its movers.
//
// Method: Dijkstra's algorithm (Numerische Mathematik 1, 1959) with a heap (route_heap.h). A link whose mover
// conditions are not met costs more, if the mover will get there without help, or cannot be used. Links that
// have failed in the game carry penalties, so that the next route avoids them.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/nav_graph.h"
#include "scripted_player/navigation/route_heap.h"

namespace temblor::player {

// links[i] leads from places[i] to places[i + 1], so there is one more place than links.
struct Route {
  std::vector<std::uint32_t> places;
  std::vector<Link> links;
  float cost = 0;
  // The first mover on it that is locked; -1: none.
  int locked_mover = -1;
};

struct RouteRules {
  // Locked movers can be passed, at a high cost.
  bool passes_locked = false;
  // Exceptions from passes_locked.
  std::vector<int> banned_movers{};
  // Places that cost more are not explored further.
  float max_cost = 1e9f;
};

class Router {
 public:
  // Both must outlive it.
  Router(const NavGraph& graph, const MoverWatch& movers);

  // Returns the route to the cheapest goal; nothing if no goal can be reached.
  std::optional<Route> find(std::uint32_t from, std::span<const std::uint32_t> goals,
                            const RouteRules& rules = {});
  // Computes the costs to all places, so that each call of find_surveyed() only looks them up. Locked movers
  // are not passed.
  void survey(std::uint32_t from);
  std::optional<Route> find_surveyed(std::span<const std::uint32_t> goals) const;
  // Returns the costs to all places, by place; 1e9 if there is no route. The span is valid until the next
  // search.
  std::span<const float> compute_costs(std::uint32_t from, const RouteRules& rules = {});
  // Returns the position nearest to that box among the places that the last search has reached.
  std::optional<math::Vec3> find_nearest_reached(const math::Bounds& box) const;
  // Raises the cost of a link that did not work.
  void penalize_link(std::uint32_t from, std::uint32_t to, float cost);
  // Keeps the penalty of the last penalized link through clear_penalties(): it has led into a dead end.
  void keep_last_penalty();
  void clear_penalties() { penalties_ = permanent_penalties_; }

 private:
  Route trace_back(std::uint32_t from, std::uint32_t to, std::span<const float> costs,
                   std::span<const std::uint32_t> came_by) const;
  void search(std::uint32_t from, const RouteRules& rules);
  float compute_cost(std::uint32_t from, const Link& link, const RouteRules& rules) const;
  bool has_penalties(std::uint32_t from) const;

  // The parts of a Link that the search reads; few links have conditions.
  struct LinkCost {
    std::uint32_t to = 0;
    float cost = 0;
    bool has_conditions = false;
  };

  const NavGraph* graph_;
  const MoverWatch* movers_;
  // The links of all places in order, and the index of the first one of each place (and one more at the end).
  std::vector<LinkCost> link_costs_;
  std::vector<std::uint32_t> first_links_;
  // Costs by the places that a link leads from and to.
  using Penalties = std::map<std::pair<std::uint32_t, std::uint32_t>, float>;
  Penalties penalties_, permanent_penalties_;
  std::optional<std::pair<std::uint32_t, std::uint32_t>> last_penalized_;
  // Results of the last search, by place: cost, and if it was reached, the index of the link that leads
  // there.
  std::vector<float> costs_;
  std::vector<std::uint32_t> came_by_;
  // Places that were reached and may lead on.
  RouteHeap open_;
  // The same for the last survey.
  std::vector<float> surveyed_costs_;
  std::vector<std::uint32_t> surveyed_by_;
  std::uint32_t surveyed_start_ = 0;
  // By place: goals of the current search, which ends at the first of them if stops_at_goal_.
  std::vector<bool> is_goal_;
  std::uint32_t reached_goal_ = 0;
  bool stops_at_goal_ = false, has_reached_ = false;
};

}  // namespace temblor::player
