#include "render/alias/light_alias.h"

#include <algorithm>
#include <span>

#include "formats/models/mdl_normals.h"
#include "render/alias/triangle_kernels.h"
#include "world/light_at.h"

namespace temblor::render {

namespace {

// Observed limits of the original.
constexpr float kMaxAmbient = 128, kMaxLight = 192;
// A colormap row is 256 steps; light 0 to 255 spans its 64 rows.
constexpr float kStepsALight = 64;
constexpr float kMinSteps = 5;
// In row kLightAsStored, and exactly 16384 for colors.
constexpr float kStepsAsStored = 8128;
// Where it goes to.
constexpr math::Vec3d kLightDirection{-1, 0, 0};

// Sixteen colors each, in the palette and so in the colormap's columns.
constexpr std::size_t kShirtFirst = 16, kPantsFirst = 96, kRowColors = 16;

// The color that position `i` of a player's row takes. Palette rows from 8 on run from bright to dark,
// against the skin's.
std::size_t player_color(std::uint8_t row, std::size_t i) {
  const std::size_t first = std::size_t{row & 15u} * kRowColors;
  const bool runs_backwards = row >= 8;
  return first + (runs_backwards ? kRowColors - 1 - i : i);
}

// Replaces both rows in each of the table's lines of 256.
template <typename Pixel>
std::span<const Pixel> dress(std::span<const Pixel> table, const PlayerColors& colors, base::Arena& arena) {
  const std::span<Pixel> dressed = arena.allocate<Pixel>(table.size());
  std::copy(table.begin(), table.end(), dressed.begin());
  for (std::size_t line = 0; line < table.size(); line += 256)
    for (std::size_t i = 0; i < kRowColors; ++i) {
      dressed[line + kShirtFirst + i] = table[line + player_color(colors.shirt, i)];
      dressed[line + kPantsFirst + i] = table[line + player_color(colors.pants, i)];
    }
  return dressed;
}

}  // namespace

AliasLight light_alias(const Scene& scene, const AliasInstance& instance, PixelFormat format,
                       bool colored_light) {
  AliasLight light;
  light.full_bright = instance.full_bright;
  if (light.full_bright) return light;
  const world::PointLight floor = world::light_at(*scene.level, scene.light_styles, instance.origin_world);
  const bool colored = format == PixelFormat::kRgb && colored_light;
  math::Vec3 shade = glm::max(colored ? floor.rgb : math::Vec3(floor.gray), math::Vec3(instance.min_light));
  math::Vec3 ambient = shade;
  for (const DynamicLight& dynamic : scene.lights) {
    const float added = dynamic.radius - glm::distance(dynamic.origin_world, instance.origin_world);
    if (added > 0) ambient += format == PixelFormat::kRgb ? dynamic.color * added : math::Vec3(added);
  }
  // Bounded by the brightest color, so that the hue stays.
  const auto brightest = [](const math::Vec3& v) { return std::max({v.x, v.y, v.z}); };
  const float most_ambient = brightest(ambient);
  if (most_ambient > 0) light.color = ambient / most_ambient;
  light.ambient = std::min(most_ambient, kMaxAmbient);
  light.shade = std::min(brightest(shade), kMaxLight - light.ambient);
  return light;
}

LightOfNormals light_normals(const AliasLight& light, const AliasPlacement& placement, PixelFormat format) {
  const math::Vec3 towards{static_cast<float>(glm::dot(kLightDirection, placement.x_axis)),
                           static_cast<float>(glm::dot(kLightDirection, placement.y_axis)),
                           static_cast<float>(glm::dot(kLightDirection, placement.z_axis))};
  const std::span<const math::Vec3> normals = formats::mdl_normals();
  LightOfNormals of_normals;
  const float unlit = std::max((255 - light.ambient) * kStepsALight, kMinSteps);
  for (std::size_t i = 0; i < of_normals.size(); ++i) {
    float steps = kStepsAsStored;
    if (!light.full_bright) {
      const math::Vec3& normal = normals[std::min(i, normals.size() - 1)];
      const float along = normal.x * towards.x + normal.y * towards.y + normal.z * towards.z;
      steps = unlit + light.shade * kStepsALight * std::min(along, 0.0f);
      steps = std::max(steps, 0.0f);
    }
    // Rows count darkness, colors take light (build_surface.cpp): half of 65280 - 4 x steps.
    of_normals[i] = format == PixelFormat::kIndexed ? steps : kBrightestLight - 2 * steps;
  }
  return of_normals;
}

const void* instance_colors(const ColorTables& tables, const AliasInstance& instance, PixelFormat format,
                            base::Arena& arena) {
  if (format == PixelFormat::kIndexed) {
    const std::span<const std::uint8_t> rows(tables.colormap.rows);
    return instance.colors ? dress(rows, *instance.colors, arena).data() : rows.data();
  }
  const std::span<const std::uint32_t> colors(tables.surface_rgb);
  return instance.colors ? dress(colors, *instance.colors, arena).data() : colors.data();
}

}  // namespace temblor::render
