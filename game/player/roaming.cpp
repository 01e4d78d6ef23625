// A deathmatch: from one thing that lies there to the next.
#include <algorithm>
#include <string_view>

#include "game/player/brain.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kReach_units = 6;
constexpr float kCostOfWay = 0.5f, kWhim = 350;
constexpr std::size_t kRemembered = 4;

float worth_of(std::string_view name, const Self& self, int weapon_bit) {
  if (name.starts_with("item_artifact_super")) return 2200;
  if (name.starts_with("item_artifact")) return 1200;
  if (name.starts_with("item_armor")) return self.armour < 100 ? 1000.0f : 300.0f;
  if (name == "item_health") return self.health < 50 ? 1500.0f : self.health < 90 ? 700.0f : 100.0f;
  if (name.starts_with("weapon_")) return (self.items & weapon_bit) == 0 ? 1600.0f : 350.0f;
  return 400;
}

}  // namespace

std::optional<Task> Brain::task_for_roaming(std::uint32_t at) {
  server::GameWorld& world = game_->world();
  const Self self = feel_self(*game_, setup_.slot);
  const std::span<const float> costs = router_.costs_from(at);
  std::optional<vm::EntityIndex> best;
  float best_value = -1e9f;
  std::uint32_t best_place = 0;
  for (std::uint32_t i = 1 + world.edicts.client_count(); i < world.edicts.count(); ++i) {
    const vm::EntityIndex entity{i};
    if (world.edicts.is_free(entity)) continue;
    const server::Edict edict = world.edicts[entity];
    if (edict.solid() != server::Solid::kTrigger || !edict.has_flag(server::flag::kItem)) continue;
    if (std::find(was_lately_.begin(), was_lately_.end(), i) != was_lately_.end()) continue;
    const std::string name = class_name(*game_, entity);
    const float worth = worth_of(name, self, weapon_bit_of(name)) + dice_.between(0, kWhim);
    for (const std::uint32_t place : map_->graph.touching(box_of(edict), kReach_units)) {
      const float value = worth - costs[place] * kCostOfWay;
      if (value <= best_value) continue;
      best_value = value;
      best = entity;
      best_place = place;
    }
  }
  if (!best) return std::nullopt;
  was_lately_.push_back(static_cast<std::uint32_t>(*best));
  if (was_lately_.size() > kRemembered) was_lately_.pop_front();
  Task task{.kind = TaskKind::kTake, .entity = *best, .box = box_of(world.edicts[*best])};
  task.describe = player::describe(*game_, *best);
  task.goals = {best_place};
  std::optional<Route> route = router_.find(at, task.goals);
  if (!route) return std::nullopt;
  task.route = std::move(*route);
  return task;
}

}  // namespace temblor::player
