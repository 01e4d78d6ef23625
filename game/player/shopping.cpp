// Which items are worth a detour.
#include <algorithm>
#include <string_view>

#include "game/player/brain.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kFarthestCost = 900, kFarthestInNeedCost = 1400;
constexpr float kWoundedHealth = 65, kFewShells = 12;
constexpr std::size_t kSmallBox = 8;

// How far somebody would go for it.
float worth_of(std::string_view name, const Self& self, int weapon_bit) {
  if (name == "item_health")
    return self.health < 40 ? 1400.0f : self.health < 65 ? 800.0f : self.health < 88 ? 350.0f : 0.0f;
  if (name.starts_with("item_armor")) return self.armour < 50 ? 500.0f : self.armour < 100 ? 200.0f : 0.0f;
  if (name.starts_with("weapon_")) return (self.items & weapon_bit) == 0 ? 900.0f : 0.0f;
  const bool has_nailgun = (self.items & 12) != 0;
  if (name == "item_shells" && self.shells < 12) return 1300;
  if (name == "item_spikes" && has_nailgun && self.nails < 20) return 1000;
  if (name == "item_shells") return self.shells < 40 ? 400.0f : self.shells < 90 ? 120.0f : 0.0f;
  if (name == "item_spikes") return self.nails < 60 ? 350.0f : self.nails < 180 ? 100.0f : 0.0f;
  if (name == "item_rockets") return self.rockets < 20 ? 300.0f : self.rockets < 90 ? 80.0f : 0.0f;
  if (name == "item_cells") return self.cells < 40 ? 250.0f : self.cells < 90 ? 80.0f : 0.0f;
  if (name.starts_with("item_artifact") || name.starts_with("item_key")) return 500;
  return 0;
}

}  // namespace

std::optional<Task> Brain::task_for_item(server::Game& io_game, const Self& self, std::uint32_t at) {
  server::GameWorld& world = io_game.world();
  const bool is_in_need = self.health < kWoundedHealth || self.shells < kFewShells;
  const std::span<const float> costs =
      router_.costs_from(at, {.most_cost = is_in_need ? kFarthestInNeedCost : kFarthestCost});
  std::optional<vm::EntityIndex> best;
  float best_gain = 0;
  std::uint32_t best_place = 0;
  for (std::uint32_t i = 1 + world.edicts.client_count(); i < world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (world.edicts.is_free(entity)) continue;
    const server::Edict edict = world.edicts[entity];
    if (edict.solid() != server::Solid::kTrigger || !edict.has_flag(server::flag::kItem)) continue;
    if (const auto tried = tried_items_.find(i); tried != tried_items_.end() && tried->second >= 2) continue;
    const std::string name = class_name(io_game, entity);
    const float worth = worth_of(name, self, weapon_bit_of(name));
    const float distance = glm::distance(edict[field::kOrigin], self.origin);
    if (worth <= 0 || distance > worth) continue;
    for (const std::uint32_t place : map_->graph.touching(box_of(edict), kSmallBox)) {
      const float gain = worth - costs[place];
      if (gain <= best_gain) continue;
      best_gain = gain;
      best = entity;
      best_place = place;
    }
  }
  if (!best) return std::nullopt;
  Task task{.kind = TaskKind::kTake, .entity = *best, .box = box_of(world.edicts[*best])};
  task.describe = player::describe(io_game, *best);
  task.goals = {best_place};
  std::optional<Route> route = router_.find(at, task.goals);
  if (!route) return std::nullopt;
  task.route = std::move(*route);
  ++tried_items_[static_cast<std::uint32_t>(*best)];
  return task;
}

}  // namespace temblor::player
