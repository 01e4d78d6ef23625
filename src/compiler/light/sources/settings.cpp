#include "compiler/light/sources/settings.h"

#include <algorithm>

#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

float positive_or(const formats::Entity& entity, std::string_view key, float otherwise) {
  const float value = number_or(entity, key, otherwise);
  return value > 0 ? value : otherwise;
}

DirtSettings dirt_of(const formats::Entity& worldspawn) {
  DirtSettings dirt;
  dirt.on = number_or(worldspawn, "dirt", 0) > 0 || number_or(worldspawn, "dirty", 0) > 0;
  dirt.depth = positive_or(worldspawn, "dirtdepth", dirt.depth);
  dirt.scale = positive_or(worldspawn, "dirtscale", dirt.scale);
  dirt.gain = positive_or(worldspawn, "dirtgain", dirt.gain);
  dirt.angle_deg = std::clamp(positive_or(worldspawn, "dirtangle", dirt.angle_deg), 1.0f, 90.0f);
  return dirt;
}

BounceSettings bounce_of(const formats::Entity& worldspawn) {
  constexpr float kMaxBounces = 16;  // what is left after them is below one step of the light map
  BounceSettings bounce;
  bounce.count = static_cast<int>(std::clamp(number_or(worldspawn, "bounce", 0), 0.0f, kMaxBounces));
  bounce.styled = number_or(worldspawn, "bouncestyled", 0) > 0;
  bounce.scale = std::max(0.0f, number_or(worldspawn, "bouncescale", bounce.scale));
  bounce.color_scale = std::clamp(number_or(worldspawn, "bouncecolorscale", 0), 0.0f, 1.0f);
  return bounce;
}

}  // namespace

LightSettings light_settings_of(const formats::Entity& worldspawn) {
  LightSettings settings;
  settings.distance_scale = positive_or(worldspawn, "dist", settings.distance_scale);
  settings.range = positive_or(worldspawn, "range", settings.range);
  settings.gamma = positive_or(worldspawn, "gamma", settings.gamma);
  settings.max_light = positive_or(worldspawn, "maxlight", 0);
  settings.angle_scale = std::clamp(number_or(worldspawn, "anglescale", settings.angle_scale), 0.0f, 1.0f);
  settings.min_light = number_or(worldspawn, "minlight", number_or(worldspawn, "light", 0));
  settings.min_light_color = color_of(worldspawn, "minlight_color").value_or(math::Vec3(1.0f));
  settings.dirt = dirt_of(worldspawn);
  settings.min_light_dirt = settings.dirt.on && number_or(worldspawn, "minlight_dirt", 0) >= 0;
  settings.bounce = bounce_of(worldspawn);
  return settings;
}

}  // namespace temblor::compiler
