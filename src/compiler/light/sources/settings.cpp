#include "compiler/light/sources/settings.h"

#include <algorithm>

#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

// For keys for which 0 and negative numbers make no sense.
float read_positive_or(const formats::Entity& entity, std::string_view key, float otherwise) {
  const float value = read_number_or(entity, key, otherwise);
  return value > 0 ? value : otherwise;
}

DirtSettings read_dirt_settings(const formats::Entity& worldspawn) {
  DirtSettings dirt;
  dirt.on = read_number_or(worldspawn, "dirt", 0) > 0 || read_number_or(worldspawn, "dirty", 0) > 0;
  dirt.depth = read_positive_or(worldspawn, "dirtdepth", dirt.depth);
  dirt.scale = read_positive_or(worldspawn, "dirtscale", dirt.scale);
  dirt.gain = read_positive_or(worldspawn, "dirtgain", dirt.gain);
  dirt.is_random = read_number_or(worldspawn, "dirtmode", 0) > 0;
  dirt.angle_deg = std::clamp(read_positive_or(worldspawn, "dirtangle", dirt.angle_deg), 1.0f, 90.0f);
  return dirt;
}

BounceSettings read_bounce_settings(const formats::Entity& worldspawn) {
  constexpr float kMaxBounces = 16;  // what is left after that is below one step of the light map
  BounceSettings bounce;
  bounce.count = static_cast<int>(std::clamp(read_number_or(worldspawn, "bounce", 0), 0.0f, kMaxBounces));
  bounce.styled = read_number_or(worldspawn, "bouncestyled", 0) > 0;
  bounce.scale = std::max(0.0f, read_number_or(worldspawn, "bouncescale", bounce.scale));
  bounce.color_scale = std::clamp(read_number_or(worldspawn, "bouncecolorscale", 0), 0.0f, 1.0f);
  return bounce;
}

// _lightmap_scale of worldspawn is a number of texels; below 1, a part of the usual 16 texels.
int read_light_map_texels(const formats::Entity& worldspawn) {
  constexpr float kUsualTexels = 16, kMaxTexels = 128;
  const float scale = std::clamp(read_number_or(worldspawn, "lightmap_scale", 0), 0.0f, kMaxTexels);
  return static_cast<int>(scale < 1 ? scale * kUsualTexels : scale);
}

}  // namespace

LightSettings read_light_settings(const formats::Entity& worldspawn) {
  LightSettings settings;
  settings.distance_scale = read_positive_or(worldspawn, "dist", settings.distance_scale);
  settings.range = read_positive_or(worldspawn, "range", settings.range);
  settings.gamma = read_positive_or(worldspawn, "gamma", settings.gamma);
  settings.max_light = read_positive_or(worldspawn, "maxlight", 0);
  settings.angle_scale =
      std::clamp(read_number_or(worldspawn, "anglescale",
                                read_number_or(worldspawn, "anglesense", settings.angle_scale)),
                 0.0f, 1.0f);
  settings.min_light = read_number_or(worldspawn, "minlight", read_number_or(worldspawn, "light", 0));
  settings.min_light_color = read_color(worldspawn, "minlight_color")
                                 .value_or(read_color(worldspawn, "mincolor").value_or(math::Vec3(1.0f)));
  settings.dirt = read_dirt_settings(worldspawn);
  settings.min_light_dirt = settings.dirt.is_taken(read_number_or(worldspawn, "minlight_dirt", 0));
  settings.adds_min_light = read_number_or(worldspawn, "addmin", 0) > 0;
  settings.spots_end_at_target = read_number_or(worldspawn, "spotlightautofalloff", 0) > 0;
  settings.light_map_texels = read_light_map_texels(worldspawn);
  settings.bounce = read_bounce_settings(worldspawn);
  settings.bounce.angle_scale = settings.angle_scale;
  settings.units_per_luxel = read_positive_or(worldspawn, "world_units_per_luxel", 0);
  return settings;
}

}  // namespace temblor::compiler
