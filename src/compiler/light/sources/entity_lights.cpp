#include "compiler/light/sources/entity_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

constexpr int kStyles = 64;
constexpr float kMaxGroup = 1 << 24;
constexpr float kDefaultValue = 300, kDefaultConeDeg = 40;

// The "light" key as one number, or as red, green, blue and brightness.
struct Brightness {
  float value = kDefaultValue;
  std::optional<math::Vec3> color;
};
Brightness read_brightness(const formats::Entity& entity) {
  if (const auto value = read_number(entity, "light")) return {*value, {}};
  const auto text = entity.find("_light") ? entity.find("_light") : entity.find("light");
  if (!text) return {};
  std::array<float, 4> numbers{0, 0, 0, kDefaultValue};
  std::size_t count = 0;
  const char* at = text->data();
  const char* const end = at + text->size();
  while (count < numbers.size()) {
    while (at < end && *at == ' ') ++at;
    const auto [next, error] = std::from_chars(at, end, numbers[count]);
    if (error != std::errc{} || !std::isfinite(numbers[count])) break;
    at = next;
    ++count;
  }
  if (count < 3) return {};
  const math::Vec3 color(numbers[0], numbers[1], numbers[2]);
  return {numbers[3], glm::max(color, math::Vec3(0.0f)) / 255.0f};
}

// The origin of the first entity with that targetname; nothing if there is none.
std::optional<math::Vec3> find_target_origin(std::span<const formats::Entity> entities,
                                             std::string_view name) {
  for (const formats::Entity& entity : entities)
    if (entity.find("targetname").value_or("") == name && entity.find_vec3("origin"))
      return entity.find_vec3("origin");
  return std::nullopt;
}

// The direction of a spotlight, toward its target or along its mangle; nothing if the light shines in all
// directions.
std::optional<math::Vec3> find_spot_direction(std::span<const formats::Entity> entities, std::size_t number,
                                              const math::Vec3& origin, Warnings& io_warnings) {
  const formats::Entity& entity = entities[number];
  if (const auto target = entity.find("target"); target && !target->empty()) {
    const auto at = find_target_origin(entities, *target);
    if (at && *at != origin) return glm::normalize(*at - origin);
    io_warnings.push_back(
        {"light with a missing target",
         fmt::format("{}: nothing to aim at is named \"{}\", so it shines in all directions",
                     describe_light(entity), base::printable(*target))});
    return std::nullopt;
  }
  return read_mangle(entity, "mangle");
}

float compute_cos_half_angle(float angle_deg) {
  const float half_deg = std::clamp(angle_deg, 0.0f, 360.0f) / 2;
  return static_cast<float>(std::cos(double{half_deg} * std::numbers::pi / 180));
}

// "angle" and "softangle" are the full angles of the cone and of its bright inner part.
Cone read_cone(const formats::Entity& entity, const math::Vec3& direction) {
  const float angle = read_number_or(entity, "angle", 0), soft_angle = read_number_or(entity, "softangle", 0);
  Cone cone;
  cone.direction = direction;
  cone.cos_outer = compute_cos_half_angle(angle > 0 ? angle : kDefaultConeDeg);
  cone.cos_inner =
      soft_angle > 0 ? std::max(cone.cos_outer, compute_cos_half_angle(soft_angle)) : cone.cos_outer;
  return cone;
}

// The formula that "delay" asks for; nothing if there is no such formula.
std::optional<Attenuation> read_attenuation(const formats::Entity& entity) {
  const float delay = read_number_or(entity, "delay", 0);
  for (int i = 0; i <= static_cast<int>(Attenuation::kInverseSquare2); ++i)
    if (delay == static_cast<float>(i)) return static_cast<Attenuation>(i);
  return std::nullopt;
}

// Numbers that no style has count as style 0, which is always on.
std::uint8_t read_style(const formats::Entity& entity) {
  const float style = read_number_or(entity, "style", 0);
  return style >= 0 && style < kStyles ? static_cast<std::uint8_t>(style) : std::uint8_t{0};
}

// A number above 0; nothing for others.
std::optional<float> read_positive(const formats::Entity& entity, std::string_view key) {
  const std::optional<float> number = read_number(entity, key);
  return number && *number > 0 ? number : std::nullopt;
}

// The end of a spotlight without _falloff, if _spotlightautofalloff asks for it: the distance to its target.
float find_falloff_at_target(std::span<const formats::Entity> entities, const formats::Entity& entity,
                             const LightSource& light) {
  const auto target = entity.find("target");
  if (light.falloff > 0 || !light.cone || !target || target->empty()) return light.falloff;
  const auto at = find_target_origin(entities, *target);
  return at ? glm::length(*at - light.origin_world) : 0;
}

// Reads a light, except its origin and direction.
LightSource read_light(const formats::Entity& entity, const LightSettings& settings,
                       Attenuation attenuation) {
  LightSource light;
  const Brightness brightness = read_brightness(entity);
  light.value = brightness.value;
  light.color = read_color(entity, "color").value_or(brightness.color.value_or(math::Vec3(1.0f)));
  light.attenuation = attenuation;
  const float wait = read_number_or(entity, "wait", 1);
  light.wait = (wait > 0 ? wait : 1) * settings.distance_scale;
  light.falloff = std::max(0.0f, read_number_or(entity, "falloff", 0));
  light.angle_scale = std::clamp(
      read_number_or(entity, "anglescale", read_number_or(entity, "anglesense", settings.angle_scale)), 0.0f,
      1.0f);
  light.style = read_style(entity);
  light.takes_dirt = settings.dirt.is_taken(read_number_or(entity, "dirt", 0));
  light.dirt_scale = read_positive(entity, "dirtscale");
  light.dirt_gain = read_positive(entity, "dirtgain");
  light.bounce_scale = std::max(0.0f, read_number_or(entity, "bouncescale", 1));
  light.channels = read_channels(entity, "light_channel_mask").value_or(1);
  light.shadow_channels = read_channels(entity, "shadow_channel_mask").value_or(light.channels);
  return light;
}

// A light with _deviance becomes several around it, which share its value if values add up.
void add_with_deviance(const formats::Entity& entity, const LightSource& light,
                       std::vector<LightSource>& io_lights) {
  constexpr float kDefaultCopies = 16, kMaxCopies = 256;
  const float deviance = read_number_or(entity, "deviance", 0);
  const int copies =
      deviance > 0
          ? static_cast<int>(std::clamp(read_number_or(entity, "samples", kDefaultCopies), 1.0f, kMaxCopies))
          : 1;
  LightSource copy = light;
  const bool shared =
      light.attenuation != Attenuation::kLinear && light.attenuation != Attenuation::kLocalMinlight;
  if (shared) copy.value /= static_cast<float>(copies);
  for (int i = 0; i < copies; ++i) {
    // Points in a cube by the additive recurrence of Roberts, "The Unreasonable Effectiveness of Quasirandom
    // Sequences" (2018): the first three powers of the root of x^4 = x + 1.
    constexpr math::Vec3d kStep(0.8191725133961645, 0.6710436067037893, 0.5497004779019703);
    const math::Vec3d unit = glm::fract(kStep * static_cast<double>(i) + 0.5) * 2.0 - 1.0;
    copy.origin_world = light.origin_world + math::Vec3(unit * double{deviance});
    io_lights.push_back(copy);
  }
}

// Adds a light, or the template of a surface light.
void add_light(std::span<const formats::Entity> entities, std::size_t number, const LightSettings& settings,
               EntityLights& io_lights, Warnings& io_warnings) {
  const formats::Entity& entity = entities[number];
  const std::optional<Attenuation> attenuation = read_attenuation(entity);
  if (!attenuation) {
    io_warnings.push_back(
        {"light with an unknown delay, ignored", describe_light(entity) + ": delay must be 0 to 5"});
    return;
  }
  LightSource light = read_light(entity, settings, *attenuation);
  light.origin_world = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
  if (const auto direction = find_spot_direction(entities, number, light.origin_world, io_warnings))
    light.cone = read_cone(entity, *direction);
  if (settings.spots_end_at_target) light.falloff = find_falloff_at_target(entities, entity, light);
  if (const auto projection = read_projection(entity, light.cone)) {
    light.projection = static_cast<std::uint32_t>(io_lights.projections.size());
    io_lights.projections.push_back(*projection);
  }
  if (const auto texture = entity.find("_surface"); texture && !texture->empty()) {
    const bool spotlight = read_number_or(entity, "surface_spotlight", 0) > 0;
    if (spotlight) light.cone = read_cone(entity, math::Vec3(0.0f));
    light.channels = light.shadow_channels = 1;
    const float group = std::clamp(read_number_or(entity, "surflight_group", 0), -kMaxGroup, kMaxGroup);
    io_lights.templates.push_back({std::string(*texture), read_number_or(entity, "surface_offset", 2),
                                   spotlight, static_cast<std::int32_t>(group),
                                   read_flag(entity, "surflight_rescale"), light});
    return;
  }
  add_with_deviance(entity, light, io_lights.lights);
}

// Lights of these kinds are read by sky_lights.h.
bool is_sun(const formats::Entity& entity) {
  return read_number_or(entity, "sun", 0) > 0 || read_number_or(entity, "sunlight2", 0) > 0 ||
         read_number_or(entity, "sunlight3", 0) > 0;
}

}  // namespace

std::string describe_light(const formats::Entity& entity) {
  return fmt::format("{} at \"{}\"", base::printable(entity.classname()),
                     base::printable(entity.find("origin").value_or("")));
}

bool is_light(const formats::Entity& entity) {
  return entity.classname().starts_with("light");
}

EntityLights find_entity_lights(std::span<const formats::Entity> entities, const LightSettings& settings,
                                Warnings& io_warnings) {
  EntityLights lights;
  for (std::size_t number = 0; number < entities.size(); ++number) {
    const formats::Entity& entity = entities[number];
    if (!is_light(entity) || is_sun(entity) || read_number_or(entity, "nostaticlight", 0) > 0) continue;
    add_light(entities, number, settings, lights, io_warnings);
  }
  return lights;
}

}  // namespace temblor::compiler
