#include "client/debris/debris.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "math/angles.h"

namespace temblor::client {

// No event counts these occasions, so the time seeds them: a demo shows the same after a seek.
std::uint64_t Debris::make_seed(std::uint32_t entity, double time_s) const {
  constexpr double kSeedsPerSecond = 72;
  return base::hash_with(base::hash_with(seed_, entity),
                         static_cast<std::uint64_t>(std::llround(time_s * kSeedsPerSecond)));
}

void Debris::clear() {
  casings_.clear();
  puffs_.clear();
  splash_times_.clear();
}

void Debris::advance(double time_s) {
  casings_.advance(time_s);
  puffs_.advance(time_s);
}

void Debris::show_shot(const InterpolatedEntity& shooter, const EffectsInput& input,
                       const math::Vec3& velocity, const EffectsSettings& settings) {
  Shot shot;
  shot.time_s = input.time_s;
  shot.velocity = velocity;
  if (shooter.number == input.view_entity && input.held_gun) {
    shot.held = *input.held_gun;
  } else if (shooter.model < input.model_names.size()) {
    const Gun gun = find_gun_of_body(input.model_names[shooter.model], shooter.to_frame);
    shot.held = place_gun_of_body(gun, shooter.origin_world, shooter.angles_deg);
  }
  shot.seed = make_seed(shooter.number, input.time_s);
  if (settings.casings) eject_casings(input.level, shot, casings_);
  if (settings.smoke) smoke_barrel(shot, puffs_);
}

// The shot came from the entity whose flash points to its end. Missiles splash as entities do.
void Debris::show_hit_in_liquid(const BurstContext& burst, const math::Vec3& end_world,
                                const EffectsInput& input) {
  constexpr float kChest = 16, kMinCosine = 0.5f, kPelletSplash = 0.35f;
  constexpr int kBubbles = 3;
  std::optional<math::Vec3> start_world;
  float best_cosine = kMinCosine;
  for (const InterpolatedEntity& entity : input.entities) {
    const math::Vec3 from = entity.origin_world + math::Vec3(0, 0, kChest);
    const float distance = glm::distance(from, end_world);
    if (!entity.has_muzzle_flash || !(distance > 0)) continue;
    const math::Vec3 forward(math::basis_from_angles(entity.angles_deg).forward);
    const float cosine = glm::dot(forward, end_world - from) / distance;
    if (cosine <= best_cosine) continue;
    best_cosine = cosine;
    start_world = from;
  }
  std::optional<Crossing> crossing;
  if (start_world) crossing = find_crossing(input.level, *start_world, end_world, input.liquids);
  if (crossing) spawn_splash(burst, *crossing, kPelletSplash, puffs_);
  const math::Vec3 above = end_world + math::Vec3(0, 0, 2 * kChest);
  spawn_bubbles(burst, crossing ? crossing->surface_world : above, end_world, kBubbles, puffs_);
}

// Doors and lifts make no splash.
void Debris::show_splash(const InterpolatedEntity& entity, const EffectsInput& input, ParticlePool& io_pool) {
  constexpr float kPlayerHeight = 56, kMinSize = 0.3f, kBubbleDepth = 48;
  const float height = entity.model < input.model_heights.size() ? input.model_heights[entity.model] : 0;
  if (entity.is_new || height <= 0) return;
  const std::optional<Crossing> crossing =
      find_crossing(input.level, entity.previous_origin_world, entity.origin_world, input.liquids);
  if (!crossing || !splash_times_.begin(entity.number, input.time_s)) return;
  EffectRandom random(make_seed(entity.number, input.time_s));
  const BurstContext burst{io_pool, random, input.time_s};
  const float size = std::clamp(height / kPlayerHeight, kMinSize, 1.0f);
  spawn_splash(burst, *crossing, size, puffs_);
  if (!crossing->enters || crossing->liquid == world::Contents::kLava) return;
  const math::Vec3 way = entity.origin_world - entity.previous_origin_world;
  const math::Vec3 below = way / std::max(glm::length(way), 0.001f) * (kBubbleDepth * size);
  spawn_bubbles(burst, crossing->surface_world, crossing->surface_world + below,
                static_cast<int>(3 + 7 * size), puffs_);
}

}  // namespace temblor::client
