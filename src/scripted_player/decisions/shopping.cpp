// Which items are worth a detour.
#include <string_view>

#include "scripted_player/decisions/brain.h"
#include "scripted_player/decisions/pick.h"

namespace temblor::player {
namespace {

namespace field = server::field;

constexpr float kMaxCost = 900, kMaxInNeedCost = 1400;
constexpr float kWoundedHealth = 65, kFewShells = 12;
constexpr float kTaken_units = 8;
constexpr int kMaxTries = 2;

// How far somebody would go for it.
float worth_shopping_for(std::string_view name, const Self& self, int weapon_bit) {
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

std::optional<Task> Brain::task_for_item(server::Game& io_game, const Self& self, std::uint32_t at) {
  const bool is_in_need = self.health < kWoundedHealth || self.shells < kFewShells;
  const std::span<const float> costs =
      router_.costs_from(at, {.most_cost = is_in_need ? kMaxInNeedCost : kMaxCost});
  const auto appraise = [&](vm::EntityIndex entity) -> std::optional<float> {
    const auto tried = tried_items_.find(static_cast<std::uint32_t>(entity));
    if (tried != tried_items_.end() && tried->second >= kMaxTries) return std::nullopt;
    const std::string name = class_name(io_game, entity);
    const float worth = worth_shopping_for(name, self, weapon_bit_of(name));
    // No way is shorter than the line.
    const float distance = glm::distance(io_game.world().edicts[entity][field::kOrigin], self.origin);
    if (worth <= 0 || distance > worth) return std::nullopt;
    return worth;
  };
  const std::optional<Pick> best =
      best_pick(io_game, map_->graph, costs, {.reach_units = kTaken_units}, appraise);
  if (!best) return std::nullopt;
  std::optional<Task> task = task_to_take(io_game, *best, at);
  if (task) ++tried_items_[static_cast<std::uint32_t>(best->entity)];
  return task;
}

}  // namespace temblor::player
