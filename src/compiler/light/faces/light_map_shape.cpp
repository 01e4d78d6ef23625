#include "compiler/light/faces/light_map_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "world/face_at.h"

namespace temblor::compiler {
namespace {

constexpr std::int32_t kStandardTexels = 16;
constexpr double kMaxSide = 65535;  // of DECOUPLED_LM, in luxels

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
  LightMapShape shape{number, texels, {}, 0, 0, false, {}};
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
  if (!(std::max(luxels[0], luxels[1]) <= kMaxSide && luxels[0] * luxels[1] <= double{kMaxFaceLuxels}))
    return std::nullopt;
  shape.width = static_cast<std::int32_t>(luxels[0]);
  shape.height = static_cast<std::int32_t>(luxels[1]);
  return shape;
}

// A direction in a plane that depends only on the plane: the world's x axis laid into it, or y if x is too
// steep.
math::Vec3d find_direction_in_plane(const math::Vec3d& normal) {
  const math::Vec3d size = glm::abs(normal);
  const math::Vec3d axis = size.x > size.y && size.x > size.z ? math::Vec3d(0, 1, 0) : math::Vec3d(1, 0, 0);
  return glm::normalize(axis - normal * glm::dot(axis, normal));
}

// Lays a grid on a face's plane; nothing if it would be too large.
std::optional<LightMapShape> make_decoupled_shape(const world::Level& level, std::uint32_t number,
                                                  double units) {
  const world::Face& face = level.faces[number];
  const world::Plane& plane = level.planes[face.plane];
  const math::Vec3d normal = glm::normalize(math::Vec3d(plane.normal)),
                    along = find_direction_in_plane(normal);
  LightMapShape shape{};
  shape.face = number;
  shape.is_decoupled = true;
  shape.axes.x_axis = math::Vec3(along / units);
  shape.axes.y_axis = math::Vec3(glm::cross(normal, along) / units);
  const auto find_luxels = [&](const math::Vec3& axis, float& out_offset) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::uint32_t k = 0; k < face.surfedge_count; ++k) {
      const math::Vec3& vertex = level.vertices[level.surfedge_start(std::size_t{face.first_surfedge} + k)];
      const double luxel = glm::dot(math::Vec3d(vertex), math::Vec3d(axis));
      low = std::min(low, luxel);
      high = std::max(high, luxel);
    }
    const double first = std::floor(low);
    out_offset = static_cast<float>(-first);
    return std::ceil(high) - first + 1;
  };
  const double width = find_luxels(shape.axes.x_axis, shape.axes.x_offset);
  const double height = find_luxels(shape.axes.y_axis, shape.axes.y_offset);
  if (!(width <= kMaxSide && height <= kMaxSide && width * height <= double{kMaxFaceLuxels}))
    return std::nullopt;
  shape.width = static_cast<std::int32_t>(width);
  shape.height = static_cast<std::int32_t>(height);
  return shape;
}

LightMapShape make_stock_shape(const world::Face& face, std::uint32_t number) {
  return {number,
          kStandardTexels,
          {face.texture_mins[0], face.texture_mins[1]},
          face.light_width(),
          face.light_height(),
          false,
          {}};
}

// The directions by_x, by_y, and by_n, in which dot(p, x), dot(p, y), and dot(p, n) grow by 1 while the
// others stay; zeros if the axes span no plane.
struct Inverse {
  math::Vec3d by_x{0.0}, by_y{0.0}, by_n{0.0};
};
Inverse invert(const math::Vec3d& x, const math::Vec3d& y, const math::Vec3d& n) {
  constexpr double kMinVolume = 1e-6;
  const double volume = glm::dot(glm::cross(x, y), n);
  if (!(std::abs(volume) > kMinVolume * glm::length(x) * glm::length(y))) return {};
  return {glm::cross(y, n) / volume, glm::cross(n, x) / volume, glm::cross(x, y) / volume};
}

}  // namespace

std::vector<LightMapShape> make_light_map_shapes(const world::Level& level, const FaceKeys& keys,
                                                 const std::vector<bool>& gets_light,
                                                 std::vector<std::uint32_t>& io_too_fine) {
  std::vector<LightMapShape> shapes;
  std::size_t luxels = 0;
  for (std::uint32_t face = 0; face < level.faces.size(); ++face)
    luxels += shapes.emplace_back(make_stock_shape(level.faces[face], face)).size();
  for (std::uint32_t face = 0; face < level.faces.size(); ++face) {
    if (!gets_light[face]) continue;
    const SurfaceKeys& own = keys.keys[keys.of_face[face]];
    const std::int32_t texels = choose_texels(own.light_map_scale);
    const bool is_decoupled = own.units_per_luxel > 0;
    if (!is_decoupled && texels == kStandardTexels) continue;
    const auto shape = is_decoupled ? make_decoupled_shape(level, face, double{own.units_per_luxel})
                                    : make_scaled_shape(level, face, texels);
    if (!shape || luxels + shape->size() > kMaxLevelLuxels) {
      io_too_fine.push_back(face);
      continue;
    }
    luxels += shape->size();
    shapes.push_back(*shape);
  }
  return shapes;
}

LuxelAxes find_luxel_axes(const world::Level& level, const LightMapShape& shape) {
  if (shape.is_decoupled) return shape.axes;
  const world::TextureAxes& axes = level.texture_axes[level.faces[shape.face].axes];
  const auto texels = static_cast<float>(shape.texels);
  return {axes.s_axis / texels, (axes.s_offset - static_cast<float>(shape.texture_mins[0])) / texels,
          axes.t_axis / texels, (axes.t_offset - static_cast<float>(shape.texture_mins[1])) / texels};
}

LuxelPlaces find_luxel_places(const world::Level& level, const LightMapShape& shape) {
  const world::FacePlane plane = world::compute_face_plane(level, level.faces[shape.face]);
  const Inverse inverse =
      invert(math::Vec3d(shape.axes.x_axis), math::Vec3d(shape.axes.y_axis), plane.normal);
  return {inverse.by_x * -double{shape.axes.x_offset} + inverse.by_y * -double{shape.axes.y_offset} +
              inverse.by_n * plane.distance,
          inverse.by_x, inverse.by_y};
}

LuxelTexels find_luxel_texels(const world::Level& level, const LightMapShape& shape) {
  if (!shape.is_decoupled)
    return {{shape.texture_mins[0], shape.texture_mins[1]}, {shape.texels, 0}, {0, shape.texels}};
  const world::TextureAxes& axes = level.texture_axes[level.faces[shape.face].axes];
  const math::Vec3d s(axes.s_axis), t(axes.t_axis);
  const LuxelPlaces places = find_luxel_places(level, shape);
  const auto texels = [&](const math::Vec3d& way) { return math::Vec2d(glm::dot(way, s), glm::dot(way, t)); };
  return {texels(places.first) + math::Vec2d(axes.s_offset, axes.t_offset), texels(places.per_x),
          texels(places.per_y)};
}

}  // namespace temblor::compiler
