#include "client/debris/splashes.h"

#include <algorithm>
#include <limits>

namespace temblor::client {

namespace {

// The first of a row of palette colors for drops; lava's glow.
std::uint8_t choose_drop_color(world::Contents liquid) {
  constexpr std::uint8_t kWater = 168, kSlime = 214, kLava = 230;
  if (liquid == world::Contents::kSlime) return kSlime;
  return liquid == world::Contents::kLava ? kLava : kWater;
}

void spawn_drops(const BurstContext& context, const Crossing& crossing, float size) {
  constexpr std::uint32_t kColors = 6;
  const auto count = static_cast<int>(40 * size);
  for (int i = 0; i < count; ++i) {
    ParticleSpawn particle;
    particle.origin_world = crossing.surface_world + context.random.uniform_in_cube(10 * size);
    particle.origin_world.z = crossing.surface_world.z + 1;
    particle.velocity = context.random.uniform_in_cube(70 * size);
    particle.velocity.z = context.random.uniform(80, 130 + 150 * size);
    particle.born_s = context.time_s;
    particle.life_s = particle.velocity.z / 400;  // until they fall back, at kDrop's gravity of 800
    particle.motion = ParticleMotion::kDrop;
    particle.color =
        static_cast<std::uint8_t>(choose_drop_color(crossing.liquid) + context.random.below(kColors));
    context.pool.add(particle);
  }
}

}  // namespace

bool is_liquid_contents(world::Contents contents) {
  return contents != world::Contents::kEmpty && contents != world::Contents::kSolid &&
         contents != world::Contents::kSky;
}

std::optional<Crossing> find_crossing(const world::Level& level, const math::Vec3& from, const math::Vec3& to,
                                      std::span<const world::PlacedLiquid> liquids) {
  constexpr float kExact = 1.0f / 16;
  const world::Contents at_start = world::point_contents(level, from, liquids);
  const world::Contents at_end = world::point_contents(level, to, liquids);
  const bool starts_inside = is_liquid_contents(at_start), ends_inside = is_liquid_contents(at_end);
  if (starts_inside == ends_inside || at_start == world::Contents::kSolid ||
      at_end == world::Contents::kSolid)
    return std::nullopt;
  math::Vec3 outside = starts_inside ? to : from, inside = starts_inside ? from : to;
  while (glm::distance(outside, inside) > kExact) {
    const math::Vec3 middle = (outside + inside) * 0.5f;
    if (middle == outside || middle == inside) break;  // far from the origin, floats are coarse
    (is_liquid_contents(world::point_contents(level, middle, liquids)) ? inside : outside) = middle;
  }
  return Crossing{outside, ends_inside ? at_end : at_start, ends_inside};
}

void spawn_splash(const BurstContext& context, const Crossing& crossing, float size, Puffs& io_puffs) {
  spawn_drops(context, crossing, size);
  if (crossing.liquid == world::Contents::kLava) return;
  for (int i = 0; i < 2; ++i) {
    PuffSpawn ring{.picture = PuffPicture::kRing,
                   .origin_world = crossing.surface_world + math::Vec3(0, 0, 0.5f)};
    ring.angles_deg = {90, context.random.uniform(0, 360), 0};
    ring.born_s = context.time_s + 0.22 * i;
    ring.life_s = 0.6 + double{size} * 0.6;
    ring.first_scale = 0.1f * size;
    ring.last_scale = (i == 0 ? 1.6f : 1.0f) * size;
    ring.opacity = 0.6f;
    io_puffs.add(ring);
  }
}

void spawn_bubbles(const BurstContext& context, const math::Vec3& surface_world, const math::Vec3& end_world,
                   int count, Puffs& io_puffs) {
  constexpr float kRise = 40;  // units per second
  for (int i = 0; i < count; ++i) {
    const float share = (static_cast<float>(i) + context.random.uniform(0.3f, 1)) / static_cast<float>(count);
    PuffSpawn bubble{.picture = PuffPicture::kBubble};
    bubble.origin_world = surface_world + (end_world - surface_world) * share;
    bubble.origin_world += context.random.uniform_in_cube(3);
    const float depth = surface_world.z - bubble.origin_world.z;
    if (depth < 1) continue;
    bubble.rise = kRise * context.random.uniform(0.7f, 1.3f);
    bubble.born_s = context.time_s + double{share} * 0.3;
    bubble.life_s = double{depth / bubble.rise};
    bubble.first_scale = context.random.uniform(0.15f, 0.35f);
    bubble.last_scale = bubble.first_scale * 1.4f;
    bubble.opacity = 0.9f;
    io_puffs.add(bubble);
  }
}

bool SplashTimes::begin(std::uint32_t entity, double time_s) {
  constexpr double kNever = -std::numeric_limits<double>::infinity();
  if (last_s_.size() <= entity) last_s_.resize(entity + std::size_t{1}, kNever);
  if (time_s - last_s_[entity] < kPause_s) return false;
  last_s_[entity] = time_s;
  return true;
}

}  // namespace temblor::client
