#include "compiler/light/faces/light_map_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace temblor::compiler {
namespace {

constexpr std::int32_t kStandardTexels = 16;
constexpr double kMaxLuxels = 1 << 20;

// The luxel distance for a scale, rounded to a power of two.
std::int32_t choose_texels(float scale) {
  constexpr float kMinPower = 0, kMaxPower = 7;
  const float power = std::clamp(std::round(std::log2(kStandardTexels * scale)), kMinPower, kMaxPower);
  return 1 << static_cast<int>(power);
}

// Follows world/loading/faces.cpp: computed in double, rounded to float once.
double compute_texel(const math::Vec3& position, const math::Vec3& axis, float offset) {
  return static_cast<float>(glm::dot(math::Vec3d(position), math::Vec3d(axis)) + double{offset});
}

// Lays a grid of another scale over a face; nothing if it would be too large.
std::optional<LightMapShape> make_scaled_shape(const world::Level& level, std::uint32_t number,
                                               std::int32_t texels) {
  const world::Face& face = level.faces[number];
  const world::TextureAxes& axes = level.texture_axes[face.axes];
  LightMapShape shape{number, texels, {}, 0, 0};
  std::array<double, 2> luxels{};
  for (std::size_t i = 0; i < 2; ++i) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::uint32_t k = 0; k < face.surfedge_count; ++k) {
      const math::Vec3& vertex = level.vertices[level.surfedge_start(std::size_t{face.first_surfedge} + k)];
      const double texel = i == 0 ? compute_texel(vertex, axes.s_axis, axes.s_offset)
                                  : compute_texel(vertex, axes.t_axis, axes.t_offset);
      low = std::min(low, texel);
      high = std::max(high, texel);
    }
    const double first = std::floor(low / texels);
    shape.texture_mins[i] = static_cast<std::int32_t>(first) * texels;
    luxels[i] = std::ceil(high / texels) - first + 1;
  }
  if (!(luxels[0] * luxels[1] <= kMaxLuxels)) return std::nullopt;
  shape.width = static_cast<std::int32_t>(luxels[0]);
  shape.height = static_cast<std::int32_t>(luxels[1]);
  return shape;
}

}  // namespace

std::vector<LightMapShape> make_light_map_shapes(const world::Level& level, const FaceKeys& keys,
                                                 const std::vector<bool>& gets_light) {
  std::vector<LightMapShape> shapes;
  for (std::uint32_t face = 0; face < level.faces.size(); ++face) {
    const world::Face& shape = level.faces[face];
    shapes.push_back({face,
                      kStandardTexels,
                      {shape.texture_mins[0], shape.texture_mins[1]},
                      shape.light_width(),
                      shape.light_height()});
  }
  for (std::uint32_t face = 0; face < level.faces.size(); ++face) {
    const std::int32_t texels = choose_texels(keys.keys[keys.of_face[face]].light_map_scale);
    if (texels == kStandardTexels || !gets_light[face]) continue;
    if (const auto shape = make_scaled_shape(level, face, texels)) shapes.push_back(*shape);
  }
  return shapes;
}

}  // namespace temblor::compiler
