// Of the things that lie there to be taken, the one that is most worth its way.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/function_ref.h"
#include "scripted_player/navigation/nav_graph.h"
#include "server/game.h"

namespace temblor::player {

// Whether it is an item that can be taken now.
bool lies_ready(const server::Edict& edict);

struct Pick {
  vm::EntityIndex entity{};
  std::uint32_t place = 0;  // where it is taken
};

struct PickRules {
  float reach_units = 0;  // how far places may be from its box
  float cost_of_way = 1;  // what a unit of the way's cost takes off the worth
  float least_value = 0;  // what the way leaves of the worth is more
};

// What a thing is worth to the player; nothing: he does not want it. Asked once for each, in their order.
using Appraisal = base::FunctionRef<std::optional<float>(vm::EntityIndex)>;

// `costs`: of the ways to all places, as Router::costs_from() tells them.
std::optional<Pick> best_pick(server::Game& io_game, const NavGraph& graph, std::span<const float> costs,
                              const PickRules& rules, Appraisal worth_of);

}  // namespace temblor::player
