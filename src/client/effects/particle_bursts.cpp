// Counts, speeds, lifetimes and colors are the original's. Where it drew random whole units, this draws any
// fraction.
#include "client/effects/particle_bursts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/hash.h"

namespace temblor::client {

namespace {

constexpr float kExplosionSize = 16, kExplosionSpeed = 256;

ParticleSpawn make_explosion_particle(const BurstContext& context, const math::Vec3& origin_world) {
  ParticleSpawn particle;
  particle.origin_world = origin_world + context.random.uniform_in_cube(kExplosionSize);
  particle.velocity = context.random.uniform_in_cube(kExplosionSpeed);
  particle.born_s = context.time_s;
  return particle;
}

// Returns one of `count` palette colors from `first` on.
std::uint8_t pick_color(EffectRandom& random, std::uint8_t first, std::uint32_t count) {
  return static_cast<std::uint8_t>(first + random.below(count));
}

// Returns 0 for a direction without length.
math::Vec3 scale_to_length(const math::Vec3& direction, float length) {
  const float old_length = glm::length(direction);
  return old_length > 0 ? direction * (length / old_length) : math::Vec3(0.0f);
}

// Returns one of `count` evenly spread points on the unit sphere (a Fibonacci lattice): each is turned from
// the last by the golden angle. Stock Quake used the 162 normals of its alias models instead.
math::Vec3d compute_sphere_point(std::size_t index, std::size_t count) {
  constexpr double kGoldenAngle = 2 * std::numbers::pi * (2 - std::numbers::phi);
  const double z = 1 - (2 * static_cast<double>(index) + 1) / static_cast<double>(count);
  const double radius = std::sqrt(1 - z * z), turn = kGoldenAngle * static_cast<double>(index);
  return {radius * std::cos(turn), radius * std::sin(turn), z};
}

}  // namespace

// Half of the sparks fly apart faster and faster, the other half slow down.
void spawn_explosion(const BurstContext& context, const math::Vec3& origin_world) {
  for (int i = 0; i < 1024; ++i) {
    ParticleSpawn particle = make_explosion_particle(context, origin_world);
    particle.life_s = 5;
    particle.motion = i % 2 == 0 ? ParticleMotion::kExplode2 : ParticleMotion::kExplode;
    particle.ramp = static_cast<float>(context.random.below(4));
    context.pool.add(particle);
  }
}

void spawn_blob_explosion(const BurstContext& context, const math::Vec3& origin_world) {
  for (int i = 0; i < 1024; ++i) {
    ParticleSpawn particle = make_explosion_particle(context, origin_world);
    particle.life_s = context.random.below(2) == 0 ? 1.0f : 1.4f;
    particle.motion = i % 2 == 0 ? ParticleMotion::kBlob2 : ParticleMotion::kBlob;
    particle.color = pick_color(context.random, i % 2 == 0 ? 150 : 66, 6);
    context.pool.add(particle);
  }
}

void spawn_colored_explosion(const BurstContext& context, const math::Vec3& origin_world,
                             std::uint8_t color_start, std::uint8_t color_count) {
  const int colors = std::max<int>(color_count, 1);
  for (int i = 0; i < 512; ++i) {
    ParticleSpawn particle = make_explosion_particle(context, origin_world);
    particle.life_s = 0.3f;
    particle.motion = ParticleMotion::kBlob;
    particle.color = static_cast<std::uint8_t>(color_start + i % colors);
    context.pool.add(particle);
  }
}

void spawn_chips(const BurstContext& context, const math::Vec3& origin_world, const math::Vec3& direction,
                 std::uint8_t color, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    ParticleSpawn particle;
    particle.origin_world = origin_world + context.random.uniform_in_cube(8);
    particle.velocity = direction * 15.0f;
    particle.born_s = context.time_s;
    particle.life_s = 0.1f * static_cast<float>(context.random.below(5));
    particle.motion = ParticleMotion::kFalling;
    particle.color = pick_color(context.random, static_cast<std::uint8_t>(color & ~7), 8);
    context.pool.add(particle);
  }
}

// A block of particles in the shape of a player, flying outward.
void spawn_teleport_splash(const BurstContext& context, const math::Vec3& origin_world) {
  constexpr int kStep = 4;
  for (int x = -16; x < 16; x += kStep)
    for (int y = -16; y < 16; y += kStep)
      for (int z = -24; z < 32; z += kStep) {
        const math::Vec3 place{x, y, z};
        const math::Vec3 shift = (context.random.uniform_in_cube(1) + 1.0f) * 2.0f;
        ParticleSpawn particle;
        particle.origin_world = origin_world + place + shift;
        particle.velocity = scale_to_length(place, context.random.uniform(50, 114));
        particle.born_s = context.time_s;
        particle.life_s = 0.2f + 0.02f * static_cast<float>(context.random.below(8));
        particle.motion = ParticleMotion::kFalling;
        particle.color = pick_color(context.random, 7, 8);
        context.pool.add(particle);
      }
}

// A square of 256 x 256 units, thrown upward and outward.
void spawn_lava_splash(const BurstContext& context, const math::Vec3& origin_world) {
  constexpr int kSide = 32;
  constexpr float kStep = 8, kUpwards = 256;
  for (int x = -kSide / 2; x < kSide / 2; ++x)
    for (int y = -kSide / 2; y < kSide / 2; ++y) {
      const float east = (static_cast<float>(x) + context.random.uniform(0, 1)) * kStep;
      const float north = (static_cast<float>(y) + context.random.uniform(0, 1)) * kStep;
      ParticleSpawn particle;
      particle.origin_world = origin_world + math::Vec3(east, north, context.random.uniform(0, 64));
      particle.velocity = scale_to_length({east, north, kUpwards}, context.random.uniform(50, 114));
      particle.born_s = context.time_s;
      particle.life_s = 2 + 0.02f * static_cast<float>(context.random.below(32));
      particle.motion = ParticleMotion::kFalling;
      particle.color = pick_color(context.random, 224, 8);
      context.pool.add(particle);
    }
}

void show_bright_field(ParticlePool& io_pool, double time_s, const math::Vec3& origin_world) {
  constexpr std::size_t kCount = 162;
  constexpr double kRadius = 64, kWander = 16;
  // Radians per second.
  constexpr double kMaxTurnSpeed = 2.55;
  for (std::size_t i = 0; i < kCount; ++i) {
    // Each particle wanders at its own constant speed, chosen by its hash.
    const std::uint64_t particle_hash = base::hash_with(0, i);
    const double yaw = time_s * kMaxTurnSpeed * static_cast<double>(particle_hash & 255) / 255;
    const double pitch = time_s * kMaxTurnSpeed * static_cast<double>(particle_hash >> 8 & 255) / 255;
    const math::Vec3d wander{std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                             -std::sin(pitch)};
    ParticleSpawn particle;
    particle.origin_world =
        origin_world + math::Vec3(compute_sphere_point(i, kCount) * kRadius + wander * kWander);
    particle.born_s = time_s;
    particle.color = 0x6f;
    io_pool.add(particle);
  }
}

// White and the yellow of sparks take turns, so that the line stands out from most walls.
void spawn_point_trail(ParticlePool& io_pool, std::span<const math::Vec3> points_world, double time_s) {
  constexpr double kApart = 16;
  constexpr float kStays_s = 1e6f;
  constexpr std::uint8_t kWhite = 15, kYellow = 0x6f;
  std::size_t count = 0;
  const auto add = [&](const math::Vec3d& at) {
    ParticleSpawn particle;
    particle.origin_world = math::Vec3(at);
    particle.born_s = time_s;
    particle.life_s = kStays_s;
    particle.color = ++count % 2 == 0 ? kYellow : kWhite;
    return io_pool.add(particle);
  };
  double next = 0;  // from the start of the piece
  for (std::size_t i = 1; i < points_world.size(); ++i) {
    const math::Vec3d from(points_world[i - 1]), to(points_world[i]);
    const double length = glm::distance(from, to);
    for (; next < length; next += kApart)
      if (!add(from + (to - from) * (next / length))) return;
    next -= length;
  }
  if (!points_world.empty()) add(math::Vec3d(points_world.back()));
}

}  // namespace temblor::client
