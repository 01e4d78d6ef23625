// Detours to items that the player needs, on the way to another task. An item is worth a detour if its value
// exceeds the cost of the route to it.
#include <string_view>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/decisions/choose_item.h"

namespace temblor::player {
namespace {

namespace field = server::field;

// Limits of the search. A player in need goes farther.
constexpr float kMaxCost = 900, kMaxInNeedCost = 1400;
constexpr float kWoundedHealth = 65, kFewShells = 12;
constexpr float kTaken_units = 8;
constexpr int kMaxTries = 2;

// Returns how far the item is worth walking for, in units; 0: not at all. The less of something the player
// has, the more.
float compute_detour_value(std::string_view name, const Self& self, int weapon_bit) {
  if (name == "item_health")
    return self.health < 40 ? 1400.0f : self.health < 65 ? 800.0f : self.health < 88 ? 350.0f : 0.0f;
  if (name.starts_with("item_armor")) return self.armor < 50 ? 500.0f : self.armor < 100 ? 200.0f : 0.0f;
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

std::optional<Task> Brain::plan_detour(server::Game& io_game, const Self& self, std::uint32_t at) {
  const bool is_in_need = self.health < kWoundedHealth || self.shells < kFewShells;
  const std::span<const float> costs =
      router_.compute_costs(at, {.max_cost = is_in_need ? kMaxInNeedCost : kMaxCost});
  const auto appraise = [&](vm::EntityIndex entity) -> std::optional<float> {
    const auto tried = item_attempts_.find(static_cast<std::uint32_t>(entity));
    if (tried != item_attempts_.end() && tried->second >= kMaxTries) return std::nullopt;
    const std::string name = class_name(io_game, entity);
    const float worth = compute_detour_value(name, self, find_weapon_bit(name));
    // No route is shorter than a straight line, so this saves the search for places that touch the item.
    const float distance = glm::distance(io_game.world().edicts[entity][field::kOrigin], self.origin);
    if (worth <= 0 || distance > worth) return std::nullopt;
    return worth;
  };
  const std::optional<ItemChoice> best =
      choose_item(io_game, map_->graph, costs, {.reach_units = kTaken_units}, appraise);
  if (!best) return std::nullopt;
  std::optional<Task> task = make_take_task(io_game, *best, at);
  if (task) ++item_attempts_[static_cast<std::uint32_t>(best->entity)];
  return task;
}

}  // namespace temblor::player
