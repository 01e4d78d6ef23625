// The lights that a level's entities describe: point lights and spotlights, and also suns, sky domes, and
// surfaces that glow, for techniques that have shadows. The keys are those of map compilers
// (docs/compiling.md). Lights are white here, and sharp: colors, penumbras, and soft cones do not count.
#pragma once

#include <algorithm>
#include <vector>

#include "world/level.h"

namespace temblor::lab {

// Its light at distance d is max(0, light - falloff * d) + inverse / d + inverse_square / d^2; key "delay"
// chooses one of the terms:
//
//   0      light - wait * d
//   1      light * 128 / (wait * d)
//   2, 5   light * (128 / (wait * d))^2
//   3      light
struct Lamp {
  math::Vec3d origin_world{0.0};
  float light = 0, falloff = 0, inverse = 0, inverse_square = 0;
  int style = 0;  // of world::LightStyleValues
  // A spotlight shines only where the cosine between this direction, of length 1, and the way from the lamp
  // is at least spot_cosine. Other lamps shine everywhere.
  math::Vec3d spot{0.0};
  double spot_cosine = kNoSpot;
  // A sun, or a part of a sky dome: it is far away, and shines where the sky is in its direction.
  bool is_sky = false;

  static constexpr double kNoSpot = -2;
  double light_at(double distance) const {
    const double d = std::max(distance, 1.0);
    return std::max(0.0, light - falloff * d) + inverse / d + inverse_square / d / d;
  }
};

// Entities whose class name begins with "light", in their order.
std::vector<Lamp> find_lamps(const world::Level& level);

// Suns and domes of worldspawn and of light entities, and points on the surfaces that glow. Without shadows,
// they would shine through walls.
std::vector<Lamp> find_shadowed_lamps(const world::Level& level);
// No surface gets more lamps once there are so many: check_ray_light refuses the level.
constexpr std::size_t kMaxShadowedLamps = 16384;

// Light that each face has at least: worldspawn's "_minlight".
float find_min_light(const world::Level& level);

}  // namespace temblor::lab
