// Bursts of particles for the server's temporary entities and svc_particle messages. Each function adds all
// of its particles to the pool at once; what the pool has no room for is dropped.
#pragma once

#include <cstdint>
#include <span>

#include "client/effects/effect_random.h"
#include "client/effects/particles.h"

namespace temblor::client {

// Where a burst's particles go, its random numbers, and when it starts (server time).
struct BurstContext {
  ParticlePool& pool;
  EffectRandom& random;
  double time_s;
};

// A rocket or grenade: 1024 sparks that burn out within 5 seconds.
void spawn_explosion(const BurstContext& context, const math::Vec3& origin_world);
// An exploding spawn (tarbaby): 1024 drops in two colors.
void spawn_blob_explosion(const BurstContext& context, const math::Vec3& origin_world);
// 512 drops in the `color_count` palette colors from `color_start` on; a count of 0 acts as 1.
void spawn_colored_explosion(const BurstContext& context, const math::Vec3& origin_world,
                             std::uint8_t color_start, std::uint8_t color_count);
// Chips of stone, sparks or blood: `count` particles in the eight palette colors around `color`, moving along
// `direction`.
void spawn_chips(const BurstContext& context, const math::Vec3& origin_world, const math::Vec3& direction,
                 std::uint8_t color, std::size_t count);
// A player or monster appears.
void spawn_teleport_splash(const BurstContext& context, const math::Vec3& origin_world);
// A boss rises from the lava.
void spawn_lava_splash(const BurstContext& context, const math::Vec3& origin_world);

// The effect EF_BRIGHTFIELD: 162 particles that wander on and around a ball of 64 units. A cloud rather than
// a burst: its particles last for one frame, so call it in every frame in which it is visible.
void show_bright_field(ParticlePool& io_pool, double time_s, const math::Vec3& origin_world);

// A line through the points: a particle every 16 units that stays until the level ends. The line ends where
// the pool is full.
void spawn_point_trail(ParticlePool& io_pool, std::span<const math::Vec3> points_world, double time_s);

}  // namespace temblor::client
