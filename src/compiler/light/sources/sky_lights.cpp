#include "compiler/light/sources/sky_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>

#include "base/text.h"
#include "compiler/light/sources/directions.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

constexpr int kMinBeams = 32;

// How finely penumbras and domes are divided.
struct SkySampling {
  int max_beams;
  float range;  // LightSettings::range
};

// The keys of a sun or dome.
struct SunKeys {
  float value = 0;
  math::Vec3 color{1.0f};
  math::Vec3 toward_sky{0, 0, 1};  // straight up by default
  float penumbra_deg = 0;
  float angle_scale = 0.5f;
  std::uint8_t style = 0;
  bool takes_dirt = false;
  std::optional<std::uint32_t> sky_name;
};

// The number of beams for a value, such that each is about one step of the light map.
int choose_beam_count(const SunKeys& sun, const SkySampling& sampling) {
  const float steps = std::abs(sun.value) * sampling.range;
  const int least = std::min(kMinBeams, sampling.max_beams);
  return static_cast<int>(
      std::clamp(steps, static_cast<float>(least), static_cast<float>(sampling.max_beams)));
}

// Adds a sun: one beam, or with a penumbra several that share its value.
void add_sun(const SunKeys& sun, const SkySampling& sampling, std::vector<SkyBeam>& io_beams) {
  if (sun.value == 0) return;
  const int beams = sun.penumbra_deg > 0 ? choose_beam_count(sun, sampling) : 1;
  const double cos_edge = std::cos(double{std::min(sun.penumbra_deg, 180.0f)} / 2 * std::numbers::pi / 180);
  const Frame frame = frame_around(sun.toward_sky);
  for (int i = 0; i < beams; ++i) {
    const math::Vec3 direction =
        beams == 1 ? sun.toward_sky : in_frame(frame, cap_direction(i, beams, cos_edge));
    io_beams.push_back({direction, sun.value / static_cast<float>(beams), sun.color, sun.angle_scale,
                        sun.style, sun.takes_dirt, sun.sky_name});
  }
}

// `up`: 1 for the dome above the level, -1 for the one below.
void add_dome(const SunKeys& dome, float up, const SkySampling& sampling, std::vector<SkyBeam>& io_beams) {
  if (dome.value == 0) return;
  const int beams = choose_beam_count(dome, sampling);
  for (int i = 0; i < beams; ++i) {
    const math::Vec3 direction = dome_direction(i, beams);
    io_beams.push_back({{direction.x, direction.y, direction.z * up},
                        dome.value / static_cast<float>(beams),
                        dome.color,
                        dome.angle_scale,
                        dome.style,
                        dome.takes_dirt,
                        dome.sky_name});
  }
}

// A mangle says where the light goes; the sky is on the other side.
math::Vec3 read_sky_direction(const formats::Entity& entity, std::string_view key,
                              const math::Vec3& otherwise) {
  const auto shines = read_mangle(entity, key);
  return shines ? -*shines : otherwise;
}

// Reads the suns and domes of worldspawn.
void add_world_sky(const formats::Entity& world, const LightSettings& settings, const SkySampling& sampling,
                   std::vector<SkyBeam>& io_beams) {
  constexpr math::Vec3 kWhite(1.0f);
  SunKeys sun;
  sun.value = read_number_or(world, "sunlight", read_number_or(world, "sun_light", 0));
  sun.color = read_color(world, "sunlight_color").value_or(read_color(world, "sun_color").value_or(kWhite));
  sun.toward_sky = read_sky_direction(world, "sun_angle", sun.toward_sky);
  sun.toward_sky =
      read_sky_direction(world, "sun_mangle", read_sky_direction(world, "sunlight_mangle", sun.toward_sky));
  sun.penumbra_deg = read_number_or(world, "sunlight_penumbra", 0);
  sun.angle_scale = settings.angle_scale;
  sun.takes_dirt = settings.dirt.is_taken(read_number_or(world, "sunlight_dirt", 0));
  add_sun(sun, sampling, io_beams);

  SunKeys second = sun;
  second.value = read_number_or(world, "sun2", 0);
  second.color = read_color(world, "sun2_color").value_or(kWhite);
  second.toward_sky = read_sky_direction(world, "sun2_mangle", math::Vec3(0, 0, 1));
  add_sun(second, sampling, io_beams);

  SunKeys dome = sun;
  dome.value = read_number_or(world, "sunlight2", 0);
  dome.color =
      read_color(world, "sunlight2_color").value_or(read_color(world, "sunlight_color2").value_or(kWhite));
  dome.takes_dirt = settings.dirt.is_taken(read_number_or(world, "sunlight2_dirt", 0));
  add_dome(dome, 1, sampling, io_beams);
  dome.value = read_number_or(world, "sunlight3", 0);
  dome.color =
      read_color(world, "sunlight3_color").value_or(read_color(world, "sunlight_color3").value_or(kWhite));
  add_dome(dome, -1, sampling, io_beams);
}

// The number of the texture that a sun's _suntexture names; nothing if the level lacks it.
std::optional<std::uint32_t> find_sky_name(const world::Level& level, std::string_view texture) {
  for (std::size_t i = 0; i < level.textures.size(); ++i)
    if (base::equal_ignoring_case(level.textures[i].name, texture)) return static_cast<std::uint32_t>(i);
  return std::nullopt;
}

// Whether a light entity makes a sun or dome.
bool is_sky_light(const formats::Entity& entity) {
  return is_light(entity) &&
         (read_number_or(entity, "sun", 0) > 0 || read_number_or(entity, "sunlight2", 0) > 0 ||
          read_number_or(entity, "sunlight3", 0) > 0);
}

// Reads the sun or dome that a light entity makes.
void add_entity_sky(std::span<const formats::Entity> entities, const formats::Entity& entity,
                    std::optional<std::uint32_t> sky_name, const LightSettings& settings,
                    const SkySampling& sampling, std::vector<SkyBeam>& io_beams) {
  SunKeys sun;
  sun.sky_name = sky_name;
  sun.value = read_number_or(entity, "light", 300);
  sun.color = read_color(entity, "color").value_or(math::Vec3(1.0f));
  sun.penumbra_deg = read_number_or(entity, "deviance", 0);
  sun.angle_scale = std::clamp(read_number_or(entity, "anglescale", settings.angle_scale), 0.0f, 1.0f);
  sun.style = static_cast<std::uint8_t>(std::clamp(read_number_or(entity, "style", 0), 0.0f, 63.0f));
  sun.takes_dirt = settings.dirt.is_taken(read_number_or(entity, "dirt", 0));
  sun.toward_sky = read_sky_direction(entity, "mangle", sun.toward_sky);
  const auto target = entity.find("target");
  for (const formats::Entity& other : entities) {
    if (!target || target->empty() || other.find("targetname").value_or("") != *target) continue;
    const math::Vec3 from = entity.find_vec3("origin").value_or(math::Vec3(0.0f));
    const math::Vec3 way = from - other.find_vec3("origin").value_or(from);
    if (way != math::Vec3(0.0f)) sun.toward_sky = glm::normalize(way);
    break;
  }
  if (read_number_or(entity, "sunlight2", 0) > 0)
    add_dome(sun, 1, sampling, io_beams);
  else if (read_number_or(entity, "sunlight3", 0) > 0)
    add_dome(sun, -1, sampling, io_beams);
  else
    add_sun(sun, sampling, io_beams);
}

}  // namespace

std::vector<SkyBeam> find_sky_beams(std::span<const formats::Entity> entities, const LightSettings& settings,
                                    int max_beams, const world::Level& level, Warnings& io_warnings) {
  const SkySampling sampling{std::max(1, max_beams), settings.range};
  std::vector<SkyBeam> beams;
  for (const formats::Entity& entity : entities) {
    if (entity.classname() == "worldspawn") add_world_sky(entity, settings, sampling, beams);
    if (!is_sky_light(entity)) continue;
    const std::string_view texture = entity.find("_suntexture").value_or("");
    const std::optional<std::uint32_t> name = find_sky_name(level, texture);
    if (!texture.empty() && !name)
      io_warnings.push_back(
          {"sun without its sky", fmt::format("{}: no face has its _suntexture \"{}\", so it does not shine",
                                              describe_light(entity), base::printable(texture))});
    else
      add_entity_sky(entities, entity, texture.empty() ? std::nullopt : name, settings, sampling, beams);
  }
  return beams;
}

}  // namespace temblor::compiler
