#include "compiler/light/sources/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.h"
#include "compiler/light/sources/entity_lights.h"
#include "compiler/light/sources/keys.h"

namespace temblor::compiler {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

// The axes of a projector: at yaw, pitch and roll 0 it looks along x, and the top of the picture is up. Roll
// turns the picture clockwise.
Frame make_axes(const math::Vec3& yaw_pitch_roll_deg) {
  const math::Vec3d angles = math::Vec3d(yaw_pitch_roll_deg) * kRadiansPerDegree;
  const double sin_yaw = std::sin(angles.x), cos_yaw = std::cos(angles.x);
  const double sin_pitch = std::sin(angles.y), cos_pitch = std::cos(angles.y);
  const math::Vec3d forward(cos_yaw * cos_pitch, sin_yaw * cos_pitch, sin_pitch);
  const math::Vec3d level_right(sin_yaw, -cos_yaw, 0), level_up = glm::cross(level_right, forward);
  const math::Vec3d right = level_right * std::cos(angles.z) - level_up * std::sin(angles.z);
  return {math::Vec3(right), math::Vec3(forward), math::Vec3(glm::cross(right, forward))};
}

// The yaw and pitch of a direction.
math::Vec3 find_angles_deg(const math::Vec3& direction) {
  const double across = std::hypot(double{direction.x}, double{direction.y});
  const double yaw = across > 0 ? std::atan2(double{direction.y}, double{direction.x}) : 0;
  return {yaw / kRadiansPerDegree, std::atan2(double{direction.z}, across) / kRadiansPerDegree, 0};
}

const world::Texture* find_texture(const world::Level& level, std::string_view name) {
  for (const world::Texture& texture : level.textures)
    if (base::equal_ignoring_case(texture.name, name) && !texture.mips[0].empty()) return &texture;
  return nullptr;
}

// The texel at a place; beyond the edge, the last one continues.
const math::Vec3& find_texel(const Projection& projection, int column, int row) {
  const int x = std::clamp(column, 0, static_cast<int>(projection.width) - 1);
  const int y = std::clamp(row, 0, static_cast<int>(projection.height) - 1);
  return projection.texels[static_cast<std::size_t>(y) * projection.width + static_cast<std::size_t>(x)];
}

}  // namespace

// A mangle gives the roll too, so it is preferred to the direction of the cone that comes from it.
std::optional<Projection> read_projection(const formats::Entity& entity, const std::optional<Cone>& cone) {
  const auto texture = entity.find("_project_texture");
  if (!texture || texture->empty()) return std::nullopt;
  constexpr float kDefaultFovDeg = 90, kMinFovDeg = 1, kMaxFovDeg = 170;
  Projection projection;
  projection.texture = std::string(*texture);
  projection.light = describe_light(entity);
  const bool has_target = !entity.find("target").value_or("").empty();
  std::optional<math::Vec3> mangle = read_vec3(entity, "project_mangle");
  if (!mangle && !has_target) mangle = read_vec3(entity, "mangle");
  projection.axes =
      make_axes(mangle ? *mangle : find_angles_deg(cone ? cone->direction : math::Vec3(0, 0, -1)));
  const float fov = std::clamp(read_number_or(entity, "project_fov", kDefaultFovDeg), kMinFovDeg, kMaxFovDeg);
  projection.half_width = static_cast<float>(std::tan(double{fov} / 2 * kRadiansPerDegree));
  return projection;
}

void load_pictures(const world::Level& level, const std::optional<formats::Palette>& palette,
                   std::span<Projection> io_projections, Warnings& io_warnings) {
  for (Projection& projection : io_projections) {
    const world::Texture* texture = find_texture(level, projection.texture);
    if (texture == nullptr) {
      io_warnings.push_back({"projected texture that the level lacks",
                             fmt::format("{}: \"{}\" is not projected; put a brush with it into the map",
                                         projection.light, base::printable(projection.texture))});
      continue;
    }
    projection.width = texture->width;
    projection.height = texture->height;
    projection.texels.reserve(texture->mips[0].size());
    for (const std::uint8_t texel : texture->mips[0]) {
      const formats::Rgb color = palette ? (*palette)[texel] : formats::Rgb{texel, texel, texel};
      projection.texels.push_back(math::Vec3(color.r, color.g, color.b) / 255.0f);
    }
  }
}

math::Vec3 find_projected_color(const Projection& projection, const math::Vec3& from_light) {
  if (projection.width == 0) return math::Vec3(1.0f);
  const float depth = glm::dot(from_light, projection.axes.forward);
  if (depth <= 0) return math::Vec3(0.0f);
  const float texels_per_unit = static_cast<float>(projection.width) / (2 * projection.half_width);
  const float s = static_cast<float>(projection.width) / 2 +
                  glm::dot(from_light, projection.axes.right) / depth * texels_per_unit;
  const float t = static_cast<float>(projection.height) / 2 -
                  glm::dot(from_light, projection.axes.up) / depth * texels_per_unit;
  if (!(s >= 0 && s <= static_cast<float>(projection.width))) return math::Vec3(0.0f);
  if (!(t >= 0 && t <= static_cast<float>(projection.height))) return math::Vec3(0.0f);
  // The color of a texel is that of its middle.
  const float left = std::floor(s - 0.5f), top = std::floor(t - 0.5f);
  const float x = s - 0.5f - left, y = t - 0.5f - top;
  const int column = static_cast<int>(left), row = static_cast<int>(top);
  const math::Vec3 above =
      glm::mix(find_texel(projection, column, row), find_texel(projection, column + 1, row), x);
  const math::Vec3 below =
      glm::mix(find_texel(projection, column, row + 1), find_texel(projection, column + 1, row + 1), x);
  return glm::mix(above, below, y);
}

math::Vec3 compute_projected_mean(const Projection& projection, const math::Vec3& from_light,
                                  const math::Vec3& across, const math::Vec3& along) {
  constexpr int kPoints = 4;  // along each side
  math::Vec3 sum(0.0f);
  for (int y = 0; y < kPoints; ++y)
    for (int x = 0; x < kPoints; ++x) {
      const float right = (static_cast<float>(x) + 0.5f) / kPoints - 0.5f;
      const float down = (static_cast<float>(y) + 0.5f) / kPoints - 0.5f;
      sum += find_projected_color(projection, from_light + across * right + along * down);
    }
  return sum / static_cast<float>(kPoints * kPoints);
}

}  // namespace temblor::compiler
