#include "world/light/sample_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace temblor::world {
namespace {

// The sum over the styles of a sample. Gray is the strongest channel, as in light maps.
PointLight sum_styles(std::span<const formats::GridLight> lights, const LightStyleValues& styles) {
  PointLight sum;
  for (const formats::GridLight& light : lights) {
    if (light.style >= styles.size()) continue;
    const float style = static_cast<float>(styles[light.style]) / 256;
    const auto& [red, green, blue] = light.rgb;
    sum.gray += static_cast<float>(std::max({red, green, blue})) * style;
    sum.rgb += math::Vec3(red, green, blue) * style;
  }
  return sum;
}

}  // namespace

std::optional<PointLight> sample_light_grid(const formats::LightGrid& grid, const LightStyleValues& styles,
                                            const math::Vec3& point_world) {
  const math::Vec3d position = (math::Vec3d(point_world) - math::Vec3d(grid.mins)) / math::Vec3d(grid.step);
  std::array<std::int32_t, 3> first{};
  math::Vec3d upper_share{0.0};
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    // Written so that it also catches positions that are not numbers.
    if (!(position[axis] > -1 && position[axis] < grid.size[i])) return std::nullopt;
    const double below = std::floor(position[axis]);
    first[i] = static_cast<std::int32_t>(below);
    upper_share[axis] = position[axis] - below;
  }
  PointLight sum;
  float weights = 0;
  for (std::int32_t corner = 0; corner < 8; ++corner) {
    std::array<std::int32_t, 3> sample = first;
    double weight = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int32_t upper = corner >> axis & 1;
      sample[static_cast<std::size_t>(axis)] += upper;
      weight *= upper != 0 ? upper_share[axis] : 1 - upper_share[axis];
    }
    if (weight <= 0) continue;
    const auto lights = find_grid_lights(grid, sample);
    if (!lights) continue;
    const PointLight light = sum_styles(*lights, styles);
    const auto share = static_cast<float>(weight);
    sum.gray += light.gray * share;
    sum.rgb += light.rgb * share;
    weights += share;
  }
  if (weights <= 0) return std::nullopt;
  return PointLight{sum.gray / weights, sum.rgb / weights};
}

}  // namespace temblor::world
