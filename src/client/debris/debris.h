// Casings, smoke, and splashes of the game's entities: finds the occasions, and keeps what they leave.
// Nothing of it is in the original; each kind has a setting.
//
//   flash of an entity --------> casing, smoke of the barrel
//   entity crosses a surface --> splash, rings, bubbles
//   shot ends in a liquid -----> splash where it went in, bubbles
#pragma once

#include <optional>
#include <span>

#include "client/debris/casings.h"
#include "client/debris/puffs.h"
#include "client/debris/splashes.h"
#include "client/effects/effects.h"
#include "client/effects/particle_bursts.h"

namespace temblor::client {

class Debris {
 public:
  // The same seed and input give the same debris.
  explicit Debris(std::uint64_t seed) : seed_(seed) {}

  void clear();
  // Moves all to their places at `time_s`.
  void advance(double time_s);

  // An entity's flash has arrived. `velocity` is the shooter's, units per second.
  void show_shot(const InterpolatedEntity& shooter, const EffectsInput& input, const math::Vec3& velocity,
                 const EffectsSettings& settings);
  // An entity has moved since the last frame.
  void show_splash(const InterpolatedEntity& entity, const EffectsInput& input, ParticlePool& io_pool);
  // A shot has ended in a liquid.
  void show_hit_in_liquid(const BurstContext& burst, const math::Vec3& end_world, const EffectsInput& input);
  // A missile has burst.
  void show_blast(const math::Vec3& origin_world, double time_s, std::uint64_t seed) {
    smoke_blast(origin_world, time_s, seed, puffs_);
  }

  // For the dust of impacts.
  Puffs& puffs() { return puffs_; }
  const Puffs& puffs() const { return puffs_; }
  std::span<const CasingPiece> casings() const { return casings_.pieces(); }

 private:
  std::uint64_t make_seed(std::uint32_t entity, double time_s) const;

  std::uint64_t seed_;
  Casings casings_;
  Puffs puffs_;
  SplashTimes splash_times_;
};

}  // namespace temblor::client
