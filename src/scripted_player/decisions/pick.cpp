#include "scripted_player/decisions/pick.h"

#include "scripted_player/navigation/level_facts.h"

namespace temblor::player {

bool lies_ready(const server::Edict& edict) {
  return edict.solid() == server::Solid::kTrigger && edict.has_flag(server::flag::kItem);
}

std::optional<Pick> best_pick(server::Game& io_game, const NavGraph& graph, std::span<const float> costs,
                              const PickRules& rules, Appraisal worth_of) {
  server::GameWorld& world = io_game.world();
  std::optional<Pick> best;
  float best_value = rules.least_value;
  for (std::uint32_t i = 1 + world.edicts.client_count(); i < world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (world.edicts.is_free(entity)) continue;
    const server::Edict edict = world.edicts[entity];
    if (!lies_ready(edict)) continue;
    const std::optional<float> worth = worth_of(entity);
    if (!worth) continue;
    for (const std::uint32_t place : graph.touching(box_of(edict), rules.reach_units)) {
      const float value = *worth - costs[place] * rules.cost_of_way;
      if (value <= best_value) continue;
      best_value = value;
      best = {entity, place};
    }
  }
  return best;
}

}  // namespace temblor::player
