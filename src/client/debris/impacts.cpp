#include "client/debris/impacts.h"

#include <algorithm>
#include <array>

#include "base/text.h"

namespace temblor::client {

namespace {

constexpr std::array<std::string_view, 23> kMetalNames = {
    "metal",  "met_", "copper", "cop",  "rust", "iron", "steel", "brass", "grate", "rivet",  "vent",  "pipe",
    "hazard", "tech", "plat",   "comp", "slip", "tek",  "door",  "gate",  "lever", "button", "barrel"};
constexpr std::array<std::string_view, 7> kWoodNames = {"wood",  "beam", "crate", "shelf",
                                                        "plank", "wdr",  "box_"};

template <std::size_t kCount>
bool has_part(const std::string& name, const std::array<std::string_view, kCount>& parts) {
  return std::any_of(parts.begin(), parts.end(),
                     [&](std::string_view part) { return name.find(part) != std::string::npos; });
}

// The first of a row of palette colors, and how many of them.
struct ColorRange {
  std::uint8_t first;
  std::uint32_t count;
};

struct Spray {
  std::size_t count;
  float speed;    // along the normal, units per second
  float scatter;  // in each direction
  float min_s, max_s;
  ParticleMotion motion;
  ColorRange colors;
};

void spawn_spray(const BurstContext& context, const Impact& impact, const Spray& spray) {
  for (std::size_t i = 0; i < spray.count; ++i) {
    ParticleSpawn particle;
    particle.origin_world = impact.origin_world + context.random.uniform_in_cube(1);
    particle.velocity = impact.normal * context.random.uniform(spray.speed * 0.3f, spray.speed) +
                        context.random.uniform_in_cube(spray.scatter);
    particle.born_s = context.time_s;
    particle.life_s = context.random.uniform(spray.min_s, spray.max_s);
    particle.motion = spray.motion;
    particle.color = static_cast<std::uint8_t>(spray.colors.first + context.random.below(spray.colors.count));
    particle.ramp = context.random.uniform(0, 2);
    context.pool.add(particle);
  }
}

void spawn_dust(const BurstContext& context, const Impact& impact, float scale, float opacity,
                Puffs& io_puffs) {
  PuffSpawn puff{.picture = PuffPicture::kDust, .origin_world = impact.origin_world + impact.normal * 2.0f};
  puff.velocity = impact.normal * context.random.uniform(20, 60) + context.random.uniform_in_cube(8);
  puff.rise = context.random.uniform(-4, 6);
  puff.born_s = context.time_s;
  puff.life_s = double{context.random.uniform(0.4f, 0.8f)};
  puff.first_scale = 0.08f;
  puff.last_scale = scale;
  puff.opacity = opacity;
  io_puffs.add(puff);
}

}  // namespace

Material find_material(std::string_view texture_name) {
  const std::string name = base::to_lower(std::string(texture_name));
  if (has_part(name, kWoodNames)) return Material::kWood;
  return has_part(name, kMetalNames) ? Material::kMetal : Material::kStone;
}

void spawn_impact(const BurstContext& context, const Impact& impact, Puffs& io_puffs) {
  // Rows of the palette: grays, and browns of wood.
  constexpr ColorRange kGrays{3, 7}, kBrowns{19, 7};
  switch (impact.material) {
    case Material::kMetal:
      spawn_spray(context, impact, {12, 220, 110, 0.15f, 0.5f, ParticleMotion::kSpark, kGrays});
      break;
    case Material::kWood:
      spawn_spray(context, impact, {12, 130, 60, 0.3f, 0.7f, ParticleMotion::kDrop, kBrowns});
      spawn_dust(context, impact, 0.25f, 0.3f, io_puffs);
      break;
    case Material::kStone:
      spawn_spray(context, impact, {8, 110, 50, 0.3f, 0.6f, ParticleMotion::kDrop, kGrays});
      spawn_dust(context, impact, 0.5f, 0.5f, io_puffs);
      break;
  }
}

}  // namespace temblor::client
