// The cheapest way through a level's places, as its moving parts are now.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "scripted_player/navigation/mover_watch.h"
#include "scripted_player/navigation/nav_graph.h"

namespace temblor::player {

struct Route {
  std::vector<std::uint32_t> places;  // from the start on; at least one
  std::vector<Way> ways;              // ways[i] leads from places[i] to places[i + 1]
  float cost = 0;
  int locked_mover = -1;  // the first on it that is locked
};

struct RouteRules {
  bool passes_locked = false;        // at a price
  std::vector<int> banned_movers{};  // as if they could never be had
  float most_cost = 1e9f;
};

class Router {
 public:
  Router(const NavGraph& graph, const MoverWatch& movers);

  // To the cheapest of the goals; nothing where none can be reached.
  std::optional<Route> find(std::uint32_t from, std::span<const std::uint32_t> goals,
                            const RouteRules& rules = {});
  // Looks for all ways from there as things are, once, for many calls of find_surveyed().
  void survey(std::uint32_t from);
  std::optional<Route> find_surveyed(std::span<const std::uint32_t> goals) const;
  // Costs to all places, 1e9f where there is no way; valid until the next search.
  std::span<const float> costs_from(std::uint32_t from, const RouteRules& rules = {});
  // Of the places that the last search has reached the one nearest to that box, in space.
  std::optional<math::Vec3> nearest_reached(const math::Bounds& box) const;
  // A way that did not work costs more from now on.
  void blame(std::uint32_t from, std::uint32_t to, float cost);
  // What was blamed last has led to where no way leads on: that is never forgiven.
  void keep_last_blame();
  void forgive() { blamed_ = kept_; }

 private:
  Route trace_back(std::uint32_t from, std::uint32_t to, std::span<const float> costs,
                   std::span<const std::uint32_t> came_from, std::span<const std::uint32_t> came_by) const;
  void search(std::uint32_t from, const RouteRules& rules);
  float cost_of(std::uint32_t from, const Way& way, const RouteRules& rules, bool& out_locked) const;

  const NavGraph* graph_;
  const MoverWatch* movers_;
  using Blames = std::map<std::pair<std::uint32_t, std::uint32_t>, float>;  // cost by places from and to
  Blames blamed_, kept_;
  std::optional<std::pair<std::uint32_t, std::uint32_t>> last_blamed_;
  std::vector<float> costs_;
  std::vector<std::uint32_t> came_from_, came_by_;  // place, and number of its way
  std::vector<float> surveyed_costs_;
  std::vector<std::uint32_t> surveyed_from_, surveyed_by_;
  std::uint32_t surveyed_start_ = 0;
  std::vector<bool> is_goal_;
  std::uint32_t reached_goal_ = 0;
  bool stops_at_goal_ = false, has_reached_ = false;
};

}  // namespace temblor::player
