#include "render/alias/light_alias.h"

#include <algorithm>
#include <span>

#include "formats/models/mdl_normals.h"
#include "render/alias/triangle_kernels.h"
#include "world/sample_light.h"

namespace temblor::render {

namespace {

// Stock Quake's limits, found by observation.
constexpr float kMaxAmbient = 128, kMaxLight = 192;
// A colormap row is 256 steps, so a light of 0 to 255 spans its 64 rows.
constexpr float kStepsPerLight = 64;
constexpr float kMinSteps = 5;
// Full-bright models: in row kLightAsStored, and exactly 16384 for colors, which shows them as they are.
constexpr float kStepsAsStored = 8128;
// The direction that the light travels in, in world space.
constexpr math::Vec3d kLightDirection{-1, 0, 0};

// Rows of sixteen palette colors, which are also columns of the colormap.
constexpr std::size_t kShirtFirst = 16, kPantsFirst = 96, kRowColors = 16;

// The palette index for position `i` of a player's row. Palette rows from 8 on run from bright to dark,
// opposite to the skin's rows.
std::size_t player_color(std::uint8_t row, std::size_t i) {
  const std::size_t first = std::size_t{row & 15u} * kRowColors;
  const bool runs_backwards = row >= 8;
  return first + (runs_backwards ? kRowColors - 1 - i : i);
}

// A copy of the table in which the shirt and pants colors are replaced, in each of its lines of 256.
template <typename Pixel>
std::span<const Pixel> replace_player_rows(std::span<const Pixel> table, const PlayerColors& colors,
                                           base::Arena& arena) {
  const std::span<Pixel> dressed = arena.allocate<Pixel>(table.size());
  std::copy(table.begin(), table.end(), dressed.begin());
  for (std::size_t line = 0; line < table.size(); line += 256)
    for (std::size_t i = 0; i < kRowColors; ++i) {
      dressed[line + kShirtFirst + i] = table[line + player_color(colors.shirt, i)];
      dressed[line + kPantsFirst + i] = table[line + player_color(colors.pants, i)];
    }
  return dressed;
}

// A copy of the colormap as colored light shows it.
std::span<const std::uint8_t> tint_colormap(const ColorTables& tables, const AliasLight& light,
                                            base::Arena& arena) {
  const std::span<const std::uint8_t> rows(tables.colormap.rows);
  const std::uint8_t* const tint = tables.tints.rows_for(light.tint_color) + light.tint_row * 256;
  const std::span<std::uint8_t> tinted = arena.allocate<std::uint8_t>(rows.size());
  std::transform(rows.begin(), rows.end(), tinted.begin(), [&](std::uint8_t index) { return tint[index]; });
  return tinted;
}

float find_brightest(const math::Vec3& light) {
  return std::max({light.x, light.y, light.z});
}
float find_darkest(const math::Vec3& light) {
  return std::min({light.x, light.y, light.z});
}

// The row of the tint table of a light of this color that is part of `sum`. The share of the light in the sum
// follows from the difference of channels, which white light does not have (Builder::make_tint()).
std::size_t choose_tint_row(const math::Vec3& sum, const math::Vec3& color) {
  const float full_difference = 1 - find_darkest(color) / find_brightest(color);
  const float share = (find_brightest(sum) - find_darkest(sum)) / (find_brightest(sum) * full_difference);
  return static_cast<std::size_t>(std::max(0.0f, std::min(1.0f, share)) * float{kTintRows - 1} + 0.5f);
}

}  // namespace

AliasLight light_alias(const Scene& scene, const AliasInstance& instance, PixelFormat format,
                       bool colored_light) {
  AliasLight light;
  light.full_bright = instance.full_bright;
  if (light.full_bright) return light;
  const world::PointLight floor =
      world::sample_light(*scene.level, scene.light_styles, instance.origin_world);
  const bool is_rgb = format == PixelFormat::kRgb;
  const math::Vec3 shade =
      glm::max(is_rgb && colored_light ? floor.rgb : math::Vec3(floor.gray), math::Vec3(instance.min_light));
  math::Vec3 ambient = shade;
  float strongest = 0;
  math::Vec3 strongest_color{1.0f};
  for (const DynamicLight& dynamic : scene.lights) {
    const float added = dynamic.radius - glm::distance(dynamic.origin_world, instance.origin_world);
    if (!(added > 0)) continue;
    const math::Vec3 color = is_rgb || colored_light ? dynamic.color : math::Vec3(1);
    ambient += color * added;
    if (added <= strongest || find_brightest(color) == find_darkest(color)) continue;
    strongest = added;
    strongest_color = color;
  }
  // The brightest channel is clamped and the others follow, so that the hue stays.
  const float max_ambient = find_brightest(ambient);
  if (is_rgb && max_ambient > 0) light.color = ambient / max_ambient;
  if (!is_rgb && strongest > 0) {
    light.tint_color = {strongest_color.x, strongest_color.y, strongest_color.z};
    light.tint_row = choose_tint_row(ambient, strongest_color);
  }
  light.ambient = std::min(max_ambient, kMaxAmbient);
  light.shade = std::min(find_brightest(shade), kMaxLight - light.ambient);
  return light;
}

NormalLights light_normals(const AliasLight& light, const AliasPlacement& placement, PixelFormat format) {
  const math::Vec3 towards{static_cast<float>(glm::dot(kLightDirection, placement.x_axis)),
                           static_cast<float>(glm::dot(kLightDirection, placement.y_axis)),
                           static_cast<float>(glm::dot(kLightDirection, placement.z_axis))};
  const std::span<const math::Vec3> normals = formats::mdl_normals();
  NormalLights by_normal;
  const float unlit = std::max((255 - light.ambient) * kStepsPerLight, kMinSteps);
  for (std::size_t i = 0; i < by_normal.size(); ++i) {
    float steps = kStepsAsStored;
    if (!light.full_bright) {
      const math::Vec3& normal = normals[std::min(i, normals.size() - 1)];
      const float along = normal.x * towards.x + normal.y * towards.y + normal.z * towards.z;
      steps = unlit + light.shade * kStepsPerLight * std::min(along, 0.0f);
      steps = std::max(steps, 0.0f);
    }
    // Colormap rows count darkness; rgb takes half the light sum (build_surface.h): (65280 - 4 * steps) / 2.
    by_normal[i] = format == PixelFormat::kIndexed ? steps : kBrightestLight - 2 * steps;
  }
  return by_normal;
}

const void* instance_colors(const ColorTables& tables, const AliasInstance& instance, const AliasLight& light,
                            PixelFormat format, base::Arena& arena) {
  if (format == PixelFormat::kIndexed) {
    std::span<const std::uint8_t> rows(tables.colormap.rows);
    if (light.tint_row != 0) rows = tint_colormap(tables, light, arena);
    return instance.colors ? replace_player_rows(rows, *instance.colors, arena).data() : rows.data();
  }
  const std::span<const std::uint32_t> colors(tables.surface_rgb);
  return instance.colors ? replace_player_rows(colors, *instance.colors, arena).data() : colors.data();
}

}  // namespace temblor::render
