// Bursts of particles: what the server's temporary entities and svc_particle look like.
#pragma once

#include <cstdint>

#include "client/effects/effect_random.h"
#include "client/effects/particles.h"

namespace temblor::client {

// Where and when bursts begin, and whence their chance comes.
struct BurstContext {
  ParticlePool& pool;
  EffectRandom& random;
  double time_s;
};

// A rocket's or grenade's: 1024 sparks that burn out.
void burst_explosion(const BurstContext& context, const math::Vec3& origin_world);
// A spawn's: 1024 drops in two colors.
void burst_blob_explosion(const BurstContext& context, const math::Vec3& origin_world);
// 512 drops in the palette's colors from `color_start` on; 0 of them counts as 1.
void burst_colored_explosion(const BurstContext& context, const math::Vec3& origin_world,
                             std::uint8_t color_start, std::uint8_t color_count);
// Chips and blood: `count` of them, in the eight colors around `color`.
void burst_chips(const BurstContext& context, const math::Vec3& origin_world, const math::Vec3& direction,
                 std::uint8_t color, std::size_t count);
void burst_teleport(const BurstContext& context, const math::Vec3& origin_world);
void burst_lava_splash(const BurstContext& context, const math::Vec3& origin_world);

// Not a burst but a cloud for as long as it is asked for: 162 particles that wander on and around a ball of
// 64 units, where they are at this moment.
void show_bright_field(ParticlePool& io_pool, double time_s, const math::Vec3& origin_world);

}  // namespace temblor::client
