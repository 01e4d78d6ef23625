// A deathmatch: from one thing that lies there to the next.
#include <algorithm>
#include <string_view>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/decisions/pick.h"

namespace temblor::player {
namespace {

constexpr float kPickedUp_units = 6;
constexpr float kCostOfWay = 0.5f, kWhim = 350;
constexpr float kWorthless = -1e9f;  // the way may cost more than what lies at its end
constexpr std::size_t kRemembered = 4;

float worth_roaming_for(std::string_view name, const Self& self, int weapon_bit) {
  if (name.starts_with("item_artifact_super")) return 2200;
  if (name.starts_with("item_artifact")) return 1200;
  if (name.starts_with("item_armor")) return self.armor < 100 ? 1000.0f : 300.0f;
  if (name == "item_health") return self.health < 50 ? 1500.0f : self.health < 90 ? 700.0f : 100.0f;
  if (name.starts_with("weapon_")) return (self.items & weapon_bit) == 0 ? 1600.0f : 350.0f;
  return 400;
}

}  // namespace

std::optional<Task> Brain::task_for_roaming(std::uint32_t at) {
  const Self self = feel_self(*game_, setup_.slot);
  const auto appraise = [&](vm::EntityIndex entity) -> std::optional<float> {
    const auto number = static_cast<std::uint32_t>(entity);
    if (std::find(was_lately_.begin(), was_lately_.end(), number) != was_lately_.end()) return std::nullopt;
    const std::string name = class_name(*game_, entity);
    return worth_roaming_for(name, self, weapon_bit_of(name)) + dice_.between(0, kWhim);
  };
  const std::optional<Pick> best = best_pick(
      *game_, map_->graph, router_.costs_from(at),
      {.reach_units = kPickedUp_units, .cost_of_way = kCostOfWay, .least_value = kWorthless}, appraise);
  if (!best) return std::nullopt;
  was_lately_.push_back(static_cast<std::uint32_t>(best->entity));
  if (was_lately_.size() > kRemembered) was_lately_.pop_front();
  return task_to_take(*game_, *best, at);
}

}  // namespace temblor::player
