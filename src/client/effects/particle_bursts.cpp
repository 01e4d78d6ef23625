// Numbers of the original; where it took whole units by chance, here any fraction of them.
#include "client/effects/particle_bursts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash.h"

namespace temblor::client {

namespace {

constexpr float kExplosionSize = 16, kExplosionSpeed = 256;

ParticleBirth of_explosion(const BurstContext& context, const math::Vec3& origin_world) {
  ParticleBirth birth;
  birth.origin_world = origin_world + context.random.in_cube(kExplosionSize);
  birth.velocity = context.random.in_cube(kExplosionSpeed);
  birth.born_s = context.time_s;
  return birth;
}

std::uint8_t one_of(EffectRandom& random, std::uint8_t first, std::uint32_t count) {
  return static_cast<std::uint8_t>(first + random.below(count));
}

math::Vec3 with_length(const math::Vec3& direction, float length) {
  const float old_length = glm::length(direction);
  return old_length > 0 ? direction * (length / old_length) : math::Vec3(0.0f);
}

// Points spread evenly over the unit ball's surface, each turned from the one before it by the golden angle.
math::Vec3d on_ball(std::size_t index, std::size_t count) {
  constexpr double kGoldenAngle = 2 * std::numbers::pi * (2 - std::numbers::phi);
  const double z = 1 - (2 * static_cast<double>(index) + 1) / static_cast<double>(count);
  const double radius = std::sqrt(1 - z * z), turn = kGoldenAngle * static_cast<double>(index);
  return {radius * std::cos(turn), radius * std::sin(turn), z};
}

}  // namespace

void burst_explosion(const BurstContext& context, const math::Vec3& origin_world) {
  for (int i = 0; i < 1024; ++i) {
    ParticleBirth birth = of_explosion(context, origin_world);
    birth.life_s = 5;
    birth.motion = i % 2 == 0 ? ParticleMotion::kExplode2 : ParticleMotion::kExplode;
    birth.ramp = static_cast<float>(context.random.below(4));
    context.pool.add(birth);
  }
}

void burst_blob_explosion(const BurstContext& context, const math::Vec3& origin_world) {
  for (int i = 0; i < 1024; ++i) {
    ParticleBirth birth = of_explosion(context, origin_world);
    birth.life_s = context.random.below(2) == 0 ? 1.0f : 1.4f;
    birth.motion = i % 2 == 0 ? ParticleMotion::kBlob2 : ParticleMotion::kBlob;
    birth.color = one_of(context.random, i % 2 == 0 ? 150 : 66, 6);
    context.pool.add(birth);
  }
}

void burst_colored_explosion(const BurstContext& context, const math::Vec3& origin_world,
                             std::uint8_t color_start, std::uint8_t color_count) {
  const int colors = std::max<int>(color_count, 1);
  for (int i = 0; i < 512; ++i) {
    ParticleBirth birth = of_explosion(context, origin_world);
    birth.life_s = 0.3f;
    birth.motion = ParticleMotion::kBlob;
    birth.color = static_cast<std::uint8_t>(color_start + i % colors);
    context.pool.add(birth);
  }
}

void burst_chips(const BurstContext& context, const math::Vec3& origin_world, const math::Vec3& direction,
                 std::uint8_t color, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ParticleBirth birth;
    birth.origin_world = origin_world + context.random.in_cube(8);
    birth.velocity = direction * 15.0f;
    birth.born_s = context.time_s;
    birth.life_s = 0.1f * static_cast<float>(context.random.below(5));
    birth.motion = ParticleMotion::kFalling;
    birth.color = one_of(context.random, static_cast<std::uint8_t>(color & ~7), 8);
    context.pool.add(birth);
  }
}

void burst_teleport(const BurstContext& context, const math::Vec3& origin_world) {
  constexpr int kStep = 4;
  for (int x = -16; x < 16; x += kStep)
    for (int y = -16; y < 16; y += kStep)
      for (int z = -24; z < 32; z += kStep) {
        const math::Vec3 place{x, y, z};
        const math::Vec3 shift = (context.random.in_cube(1) + 1.0f) * 2.0f;
        ParticleBirth birth;
        birth.origin_world = origin_world + place + shift;
        birth.velocity = with_length(place, context.random.uniform(50, 114));
        birth.born_s = context.time_s;
        birth.life_s = 0.2f + 0.02f * static_cast<float>(context.random.below(8));
        birth.motion = ParticleMotion::kFalling;
        birth.color = one_of(context.random, 7, 8);
        context.pool.add(birth);
      }
}

void burst_lava_splash(const BurstContext& context, const math::Vec3& origin_world) {
  constexpr int kSide = 32;
  constexpr float kStep = 8, kUpwards = 256;
  for (int x = -kSide / 2; x < kSide / 2; ++x)
    for (int y = -kSide / 2; y < kSide / 2; ++y) {
      const float east = (static_cast<float>(x) + context.random.uniform(0, 1)) * kStep;
      const float north = (static_cast<float>(y) + context.random.uniform(0, 1)) * kStep;
      ParticleBirth birth;
      birth.origin_world = origin_world + math::Vec3(east, north, context.random.uniform(0, 64));
      birth.velocity = with_length({east, north, kUpwards}, context.random.uniform(50, 114));
      birth.born_s = context.time_s;
      birth.life_s = 2 + 0.02f * static_cast<float>(context.random.below(32));
      birth.motion = ParticleMotion::kFalling;
      birth.color = one_of(context.random, 224, 8);
      context.pool.add(birth);
    }
}

void show_bright_field(ParticlePool& io_pool, double time_s, const math::Vec3& origin_world) {
  constexpr std::size_t kCount = 162;
  constexpr double kRadius = 64, kWander = 16;
  constexpr double kFastest = 2.55;  // radians a second
  for (std::size_t i = 0; i < kCount; ++i) {
    // Each wanders at a pace of its own, always the same.
    const std::uint64_t own = base::hash_with(0, i);
    const double yaw = time_s * kFastest * static_cast<double>(own & 255) / 255;
    const double pitch = time_s * kFastest * static_cast<double>(own >> 8 & 255) / 255;
    const math::Vec3d wander{std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                             -std::sin(pitch)};
    ParticleBirth birth;
    birth.origin_world = origin_world + math::Vec3(on_ball(i, kCount) * kRadius + wander * kWander);
    birth.born_s = time_s;
    birth.color = 0x6f;
    io_pool.add(birth);
  }
}

}  // namespace temblor::client
