#include "render/models/light_alias.h"

#include <algorithm>
#include <span>

#include "formats/mdl_normals.h"
#include "render/models/triangle_kernels.h"
#include "world/light_at.h"

namespace temblor::render {

namespace {

// Observed limits of the original.
constexpr float kMostAmbient = 128, kMostLight = 192;
// A colormap row is 256 steps; light 0 to 255 spans its 64 rows.
constexpr float kStepsALight = 64;
constexpr float kLeastSteps = 5;
// In row kLightAsStored, and exactly 16384 for colours.
constexpr float kStepsAsStored = 8128;
// Where it goes to.
constexpr math::Vec3d kLightDirection{-1, 0, 0};

// Sixteen colours each, in the palette and so in the colormap's columns.
constexpr std::size_t kShirtFirst = 16, kPantsFirst = 96, kRowColours = 16;

// The colour that position `i` of a player's row takes. Palette rows from 8 on run from bright to dark,
// against the skin's.
std::size_t player_colour(std::uint8_t row, std::size_t i) {
  const std::size_t first = std::size_t{row & 15u} * kRowColours;
  const bool runs_backwards = row >= 8;
  return first + (runs_backwards ? kRowColours - 1 - i : i);
}

// Replaces both rows in each of the table's lines of 256.
template <typename Pixel>
std::span<const Pixel> dress(std::span<const Pixel> table, const PlayerColours& colours, base::Arena& arena) {
  const std::span<Pixel> dressed = arena.allocate<Pixel>(table.size());
  std::copy(table.begin(), table.end(), dressed.begin());
  for (std::size_t line = 0; line < table.size(); line += 256)
    for (std::size_t i = 0; i < kRowColours; ++i) {
      dressed[line + kShirtFirst + i] = table[line + player_colour(colours.shirt, i)];
      dressed[line + kPantsFirst + i] = table[line + player_colour(colours.pants, i)];
    }
  return dressed;
}

}  // namespace

AliasLight light_alias(const Scene& scene, const AliasInstance& instance, PixelFormat format,
                       bool coloured_light) {
  AliasLight light;
  light.full_bright = instance.full_bright;
  if (light.full_bright) return light;
  const world::PointLight floor = world::light_at(*scene.level, scene.light_styles, instance.origin_world);
  const bool coloured = format == PixelFormat::kRgb && coloured_light;
  math::Vec3 shade =
      glm::max(coloured ? floor.rgb : math::Vec3(floor.grey), math::Vec3(instance.least_light));
  math::Vec3 ambient = shade;
  for (const DynamicLight& dynamic : scene.lights) {
    const float added = dynamic.radius - glm::distance(dynamic.origin_world, instance.origin_world);
    if (added > 0) ambient += format == PixelFormat::kRgb ? dynamic.colour * added : math::Vec3(added);
  }
  // Bounded by the brightest colour, so that the hue stays.
  const auto brightest = [](const math::Vec3& v) { return std::max({v.x, v.y, v.z}); };
  const float most_ambient = brightest(ambient);
  if (most_ambient > 0) light.colour = ambient / most_ambient;
  light.ambient = std::min(most_ambient, kMostAmbient);
  light.shade = std::min(brightest(shade), kMostLight - light.ambient);
  return light;
}

LightOfNormals light_normals(const AliasLight& light, const AliasPlacement& placement, PixelFormat format) {
  const math::Vec3 towards{static_cast<float>(glm::dot(kLightDirection, placement.x_axis)),
                           static_cast<float>(glm::dot(kLightDirection, placement.y_axis)),
                           static_cast<float>(glm::dot(kLightDirection, placement.z_axis))};
  const std::span<const math::Vec3> normals = formats::mdl_normals();
  LightOfNormals of_normals;
  const float unlit = std::max((255 - light.ambient) * kStepsALight, kLeastSteps);
  for (std::size_t i = 0; i < of_normals.size(); ++i) {
    float steps = kStepsAsStored;
    if (!light.full_bright) {
      const math::Vec3& normal = normals[std::min(i, normals.size() - 1)];
      const float along = normal.x * towards.x + normal.y * towards.y + normal.z * towards.z;
      steps = unlit + light.shade * kStepsALight * std::min(along, 0.0f);
      steps = std::max(steps, 0.0f);
    }
    // Rows count darkness, colours take light (build_surface.cpp): half of 65280 - 4 x steps.
    of_normals[i] = format == PixelFormat::kIndexed ? steps : kBrightestLight - 2 * steps;
  }
  return of_normals;
}

const void* instance_colours(const ColourTables& tables, const AliasInstance& instance, PixelFormat format,
                             base::Arena& arena) {
  if (format == PixelFormat::kIndexed) {
    const std::span<const std::uint8_t> rows(tables.colormap.rows);
    return instance.colours ? dress(rows, *instance.colours, arena).data() : rows.data();
  }
  const std::span<const std::uint32_t> colours(tables.surface_rgb);
  return instance.colours ? dress(colours, *instance.colours, arena).data() : colours.data();
}

}  // namespace temblor::render
