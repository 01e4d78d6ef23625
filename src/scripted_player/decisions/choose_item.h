// Chooses the item whose value most exceeds the cost of the route to it. The callers differ in the values:
// detours on the way to an exit (item_detours.cpp), and tours of a deathmatch (deathmatch_items.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "base/function_ref.h"
#include "scripted_player/navigation/nav_graph.h"
#include "server/game.h"

namespace temblor::player {

// Returns whether it is an item that can be picked up now. Game code makes items not solid until they
// respawn.
bool is_item_available(const server::Edict& edict);

struct ItemChoice {
  vm::EntityIndex entity{};
  // Where the player picks it up.
  std::uint32_t place = 0;
};

// Net value = value - cost_weight * cost of the route. Costs are about units of walking, so values are how
// far an item is worth walking for.
struct ItemChoiceRules {
  // A place counts as touching the item up to this distance.
  float reach_units = 0;
  float cost_weight = 1;
  // The net value must exceed this.
  float min_value = 0;
};

// Returns the value of an item to the player; nothing if the player does not want it. Called once per item,
// in order of entities, so it may draw random numbers.
using ItemValue = base::FunctionRef<std::optional<float>(vm::EntityIndex)>;

// Returns the best item, or nothing. `costs` are the costs of the routes to all places, from
// Router::compute_costs().
std::optional<ItemChoice> choose_item(server::Game& io_game, const NavGraph& graph,
                                      std::span<const float> costs, const ItemChoiceRules& rules,
                                      ItemValue item_value);

}  // namespace temblor::player
