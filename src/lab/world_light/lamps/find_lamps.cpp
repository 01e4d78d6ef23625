#include "lab/world_light/lamps/find_lamps.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "base/text.h"
#include "render/view/model_view.h"
#include "world/animation.h"

namespace temblor::lab {

namespace {

using formats::Entity;

constexpr float kDefaultLight = 300;
// Where lamps with an inverse falloff give as much as their key "light".
constexpr float kUnits = 128;
constexpr float kDefaultCone_deg = 40;
// Beyond any level.
constexpr double kSkyDistance = 1e6;
// Glowing surfaces have a lamp in the middle of each square of this size.
constexpr double kSquare_units = 128;
constexpr double kSurfaceOffset_units = 2;
// On a face, along each side.
constexpr double kMaxSquares = 64;

// Keys may begin with an underscore.
std::optional<std::string_view> find_key(const Entity& entity, const std::string& key) {
  const auto found = entity.find("_" + key);
  return found ? found : entity.find(key);
}
float find_number(const Entity& entity, const std::string& key, float otherwise) {
  const auto found = entity.find_number("_" + key);
  return found ? *found : entity.find_number(key).value_or(otherwise);
}

// The way that "yaw pitch roll" shines, in degrees; a pitch below 0 is down.
std::optional<math::Vec3d> find_mangle(const Entity& entity, const std::string& key) {
  std::optional<math::Vec3> angles_deg = entity.find_vec3("_" + key);
  if (!angles_deg) angles_deg = entity.find_vec3(key);
  if (!angles_deg) return std::nullopt;
  const math::Vec3d angles = math::Vec3d(*angles_deg) * (std::numbers::pi / 180);
  return math::Vec3d(std::cos(angles.x) * std::cos(angles.y), std::sin(angles.x) * std::cos(angles.y),
                     std::sin(angles.y));
}

std::optional<math::Vec3d> find_target(const world::Level& level, const Entity& entity) {
  const auto target = entity.find("target");
  if (!target || target->empty()) return std::nullopt;
  for (const Entity& other : level.entities)
    if (other.find("targetname").value_or("") == *target)
      if (const auto origin = other.find_vec3("origin")) return math::Vec3d(*origin);
  return std::nullopt;
}

bool is_light(const Entity& entity) {
  return entity.classname().starts_with("light");
}
bool is_sky_light(const Entity& entity) {
  return find_number(entity, "sun", 0) > 0 || find_number(entity, "sunlight2", 0) > 0 ||
         find_number(entity, "sunlight3", 0) > 0;
}

// Brightness and falloff. Nothing for lights that take light away, or none at all.
std::optional<Lamp> read_brightness(const Entity& entity) {
  const float light = find_number(entity, "light", kDefaultLight);
  if (!(light > 0)) return std::nullopt;
  Lamp lamp;
  const float wait = std::max(std::abs(find_number(entity, "wait", 1)), 1.0f / 128);
  const float delay = find_number(entity, "delay", 0);
  if (delay == 1) {
    lamp.inverse = light * kUnits / wait;
  } else if (delay == 2 || delay == 5) {
    lamp.inverse_square = light * (kUnits / wait) * (kUnits / wait);
  } else {
    lamp.light = light;
    lamp.falloff = delay == 3 ? 0 : wait;
  }
  const float style = find_number(entity, "style", 0);
  if (style >= 0 && style < static_cast<float>(world::kLightStyles)) lamp.style = static_cast<int>(style);
  return lamp;
}

void aim(const math::Vec3d& direction, double cone_deg, Lamp& io_lamp) {
  const double length = glm::length(direction);
  if (!(length > 0)) return;
  io_lamp.spot = direction / length;
  io_lamp.spot_cosine = std::cos(std::clamp(cone_deg, 0.0, 360.0) / 2 * std::numbers::pi / 180);
}

void aim_spotlight(const world::Level& level, const Entity& entity, Lamp& io_lamp) {
  std::optional<math::Vec3d> direction = find_mangle(entity, "mangle");
  if (const auto target = find_target(level, entity)) direction = *target - io_lamp.origin_world;
  const float angle_deg = find_number(entity, "angle", 0);
  if (direction) aim(*direction, angle_deg > 0 ? angle_deg : kDefaultCone_deg, io_lamp);
}

void add_sun(float light, const math::Vec3d& toward_sky, int style, std::vector<Lamp>& io_lamps) {
  if (!(light > 0)) return;
  io_lamps.push_back(
      {.origin_world = toward_sky * kSkyDistance, .light = light, .style = style, .is_sky = true});
}

// The middle of the dome and two rings. `up`: 1 for the upper half, -1 for the lower one.
void add_dome(float light, double up, int style, std::vector<Lamp>& io_lamps) {
  constexpr int kPerRing = 8;
  constexpr double kElevations_deg[] = {18, 54};
  const float each = light / (1 + 2 * kPerRing);
  add_sun(each, {0, 0, up}, style, io_lamps);
  for (const double elevation_deg : kElevations_deg)
    for (int i = 0; i < kPerRing; ++i) {
      const double elevation = elevation_deg * std::numbers::pi / 180,
                   turn = i * 2 * std::numbers::pi / kPerRing;
      add_sun(each,
              {std::cos(turn) * std::cos(elevation), std::sin(turn) * std::cos(elevation),
               up * std::sin(elevation)},
              style, io_lamps);
    }
}

void add_world_sky(const Entity& world, std::vector<Lamp>& io_lamps) {
  const auto find_sky = [&](const std::string& key) -> std::optional<math::Vec3d> {
    const auto shines = find_mangle(world, key);
    return shines ? std::optional(-*shines) : std::nullopt;
  };
  const math::Vec3d above(0, 0, 1);
  std::optional<math::Vec3d> sun = find_sky("sun_mangle");
  if (!sun) sun = find_sky("sunlight_mangle");
  add_sun(find_number(world, "sunlight", 0), sun.value_or(above), 0, io_lamps);
  add_sun(find_number(world, "sun2", 0), find_sky("sun2_mangle").value_or(above), 0, io_lamps);
  if (const float light = find_number(world, "sunlight2", 0); light > 0) add_dome(light, 1, 0, io_lamps);
  if (const float light = find_number(world, "sunlight3", 0); light > 0) add_dome(light, -1, 0, io_lamps);
}

void add_entity_sky(const world::Level& level, const Entity& entity, std::vector<Lamp>& io_lamps) {
  const std::optional<Lamp> lamp = read_brightness(entity);
  if (!lamp) return;
  const float light = find_number(entity, "light", kDefaultLight);
  math::Vec3d toward_sky(0, 0, 1);
  if (const auto shines = find_mangle(entity, "mangle")) toward_sky = -*shines;
  const auto target = find_target(level, entity);
  const auto origin = entity.find_vec3("origin");
  if (target && origin && math::Vec3d(*origin) != *target)
    toward_sky = glm::normalize(math::Vec3d(*origin) - *target);
  if (find_number(entity, "sunlight2", 0) > 0)
    add_dome(light, 1, lamp->style, io_lamps);
  else if (find_number(entity, "sunlight3", 0) > 0)
    add_dome(light, -1, lamp->style, io_lamps);
  else
    add_sun(light, toward_sky, lamp->style, io_lamps);
}

std::vector<math::Vec3d> find_corners(const world::Level& level, const world::Face& face) {
  std::vector<math::Vec3d> corners;
  for (std::uint32_t i = 0; i < face.surfedge_count; ++i)
    corners.emplace_back(level.vertices[level.surfedge_start(face.first_surfedge + i)]);
  return corners;
}

// Clockwise, seen from the front.
bool is_inside(const std::vector<math::Vec3d>& corners, const math::Vec3d& normal, const math::Vec3d& at) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const math::Vec3d side = corners[(i + 1) % corners.size()] - corners[i];
    if (glm::dot(glm::cross(side, normal), at - corners[i]) < 0) return false;
  }
  return true;
}

// The middles of the squares of a grid on the face; the face's own middle if none is inside.
std::vector<math::Vec3d> divide_face(const std::vector<math::Vec3d>& corners, const math::Vec3d& normal) {
  const math::Vec3d helper = std::abs(normal.z) < 0.7 ? math::Vec3d(0, 0, 1) : math::Vec3d(1, 0, 0);
  const math::Vec3d right = glm::normalize(glm::cross(helper, normal)), up = glm::cross(normal, right);
  math::Vec3d middle(0.0);
  math::Vec2d low(1e30), high(-1e30);
  for (const math::Vec3d& corner : corners) {
    middle += corner / static_cast<double>(corners.size());
    const math::Vec2d at(glm::dot(right, corner), glm::dot(up, corner));
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  const math::Vec2d squares =
      glm::clamp(glm::ceil((high - low) / kSquare_units - 1e-6), math::Vec2d(1.0), math::Vec2d(kMaxSquares));
  std::vector<math::Vec3d> points;
  for (int y = 0; y < static_cast<int>(squares.y); ++y)
    for (int x = 0; x < static_cast<int>(squares.x); ++x) {
      const math::Vec2d at = low + (high - low) / squares * math::Vec2d(x + 0.5, y + 0.5);
      const math::Vec3d point = right * at.x + up * at.y + normal * glm::dot(normal, middle);
      if (is_inside(corners, normal, point)) points.push_back(point);
    }
  if (points.empty()) points.push_back(middle);
  return points;
}

// The lamps of surfaces that have the texture that a light names.
void add_surfaces(const world::Level& level, const Entity& entity, std::string_view texture,
                  std::vector<Lamp>& io_lamps) {
  const std::optional<Lamp> brightness = read_brightness(entity);
  if (!brightness) return;
  const double offset = static_cast<double>(find_number(entity, "surface_offset", kSurfaceOffset_units));
  const bool is_spotlight = find_number(entity, "surface_spotlight", 0) > 0;
  const float angle_deg = find_number(entity, "angle", 0);
  const world::Model& world = level.models.front();
  for (std::uint32_t i = world.first_face; i < world.first_face + world.face_count; ++i) {
    const world::Face& face = level.faces[i];
    if (!base::equal_ignoring_case(level.texture(face.texture).name, texture)) continue;
    const math::Vec3d normal = render::place_plane(level, face, {}).normal;
    for (const math::Vec3d& point : divide_face(find_corners(level, face), normal)) {
      if (io_lamps.size() >= kMaxShadowedLamps) return;
      Lamp lamp = *brightness;
      lamp.origin_world = point + normal * offset;
      constexpr double kHalfSphere_deg = 180;
      aim(normal, !is_spotlight ? kHalfSphere_deg : angle_deg > 0 ? angle_deg : kDefaultCone_deg, lamp);
      io_lamps.push_back(lamp);
    }
  }
}

}  // namespace

std::vector<Lamp> find_lamps(const world::Level& level) {
  std::vector<Lamp> lamps;
  for (const Entity& entity : level.entities) {
    const std::optional<math::Vec3> origin = entity.find_vec3("origin");
    if (!is_light(entity) || is_sky_light(entity) || find_key(entity, "surface") || !origin) continue;
    std::optional<Lamp> lamp = read_brightness(entity);
    if (!lamp) continue;
    lamp->origin_world = math::Vec3d(*origin);
    aim_spotlight(level, entity, *lamp);
    lamps.push_back(*lamp);
  }
  return lamps;
}

std::vector<Lamp> find_shadowed_lamps(const world::Level& level) {
  std::vector<Lamp> lamps;
  for (const Entity& entity : level.entities) {
    if (entity.classname() == "worldspawn") add_world_sky(entity, lamps);
    if (!is_light(entity)) continue;
    if (is_sky_light(entity)) add_entity_sky(level, entity, lamps);
    if (const auto texture = find_key(entity, "surface")) add_surfaces(level, entity, *texture, lamps);
  }
  return lamps;
}

float find_min_light(const world::Level& level) {
  for (const Entity& entity : level.entities)
    if (entity.classname() == "worldspawn")
      return std::clamp(find_number(entity, "minlight", find_number(entity, "light", 0)), 0.0f, 255.0f);
  return 0;
}

}  // namespace temblor::lab
