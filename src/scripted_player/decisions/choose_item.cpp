#include "scripted_player/decisions/choose_item.h"

#include "scripted_player/navigation/level_facts.h"

namespace temblor::player {

bool is_item_available(const server::Edict& edict) {
  return edict.solid() == server::Solid::kTrigger && edict.has_flag(server::flag::kItem);
}

std::optional<ItemChoice> choose_item(server::Game& io_game, const NavGraph& graph,
                                      std::span<const float> costs, const ItemChoiceRules& rules,
                                      ItemValue item_value) {
  server::GameWorld& world = io_game.world();
  std::optional<ItemChoice> best;
  float best_value = rules.min_value;
  for (std::uint32_t i = 1 + world.edicts.client_count(); i < world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (world.edicts.is_free(entity)) continue;
    const server::Edict edict = world.edicts[entity];
    if (!is_item_available(edict)) continue;
    const std::optional<float> worth = item_value(entity);
    if (!worth) continue;
    for (const std::uint32_t place : graph.find_touching(entity_box(edict), rules.reach_units)) {
      const float value = *worth - costs[place] * rules.cost_weight;
      if (value <= best_value) continue;
      best_value = value;
      best = {entity, place};
    }
  }
  return best;
}

}  // namespace temblor::player
