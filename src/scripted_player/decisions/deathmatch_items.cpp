// Deathmatch: goes from item to item, by value and distance. The last few are skipped, and a random bonus
// varies the tour.
#include <algorithm>
#include <string_view>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/decisions/choose_item.h"

namespace temblor::player {
namespace {

constexpr float kPickedUp_units = 6;
constexpr float kCostWeight = 0.5f, kMaxRandomBonus = 350;
// Go somewhere, even if the route costs more than the item is worth.
constexpr float kMinValue = -1e9f;
// The last items are skipped, so that the player moves through the whole level.
constexpr std::size_t kRemembered = 4;

// Returns how far the item is worth walking for, in units. `weapon_bit` is the item's, if it is a weapon.
float compute_deathmatch_value(std::string_view name, const Self& self, int weapon_bit) {
  if (name.starts_with("item_artifact_super")) return 2200;
  if (name.starts_with("item_artifact")) return 1200;
  if (name.starts_with("item_armor")) return self.armor < 100 ? 1000.0f : 300.0f;
  if (name == "item_health") return self.health < 50 ? 1500.0f : self.health < 90 ? 700.0f : 100.0f;
  if (name.starts_with("weapon_")) return (self.items & weapon_bit) == 0 ? 1600.0f : 350.0f;
  return 400;
}

}  // namespace

std::optional<Task> Brain::plan_deathmatch_item(std::uint32_t at) {
  const Self self = read_self(*game_, setup_.slot);
  const auto appraise = [&](vm::EntityIndex entity) -> std::optional<float> {
    const auto number = static_cast<std::uint32_t>(entity);
    if (std::find(recent_items_.begin(), recent_items_.end(), number) != recent_items_.end())
      return std::nullopt;
    const std::string name = class_name(*game_, entity);
    return compute_deathmatch_value(name, self, find_weapon_bit(name)) + dice_.between(0, kMaxRandomBonus);
  };
  const std::optional<ItemChoice> best = choose_item(
      *game_, map_->graph, router_.compute_costs(at),
      {.reach_units = kPickedUp_units, .cost_weight = kCostWeight, .min_value = kMinValue}, appraise);
  if (!best) return std::nullopt;
  recent_items_.push_back(static_cast<std::uint32_t>(best->entity));
  if (recent_items_.size() > kRemembered) recent_items_.pop_front();
  return make_take_task(*game_, *best, at);
}

}  // namespace temblor::player
