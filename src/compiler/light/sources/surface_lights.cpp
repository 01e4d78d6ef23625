// A large face becomes many small lights, since a single one at its center would be too bright next to it and
// would cast hard shadows.
#include "compiler/light/sources/surface_lights.h"

#include <cmath>
#include <limits>

#include "base/text.h"
#include "world/face_at.h"

namespace temblor::compiler {
namespace {

constexpr double kGridUnits = 128;

using Polygon = std::vector<math::Vec3d>;

// Cuts off the parts of a convex polygon below `low` and above `high` on an axis.
Polygon slice(const Polygon& polygon, int axis, double low, double high) {
  Polygon kept = polygon;
  for (const double sign : {1.0, -1.0}) {
    const double limit = sign > 0 ? low : -high;
    Polygon cut;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      const math::Vec3d& a = kept[i];
      const math::Vec3d& b = kept[(i + 1) % kept.size()];
      const double inside_a = a[axis] * sign - limit, inside_b = b[axis] * sign - limit;
      if (inside_a >= 0) cut.push_back(a);
      if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0))
        cut.push_back(a + (b - a) * (inside_a / (inside_a - inside_b)));
    }
    kept = std::move(cut);
  }
  return kept;
}

// Cuts a polygon along the planes of the world's grid, one axis after another.
std::vector<Polygon> cut_into_pieces(const Polygon& polygon) {
  constexpr double kOnGrid = 0.01;  // so that a corner on a plane makes no sliver
  std::vector<Polygon> pieces{polygon};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Polygon> finer;
    for (const Polygon& piece : pieces) {
      double low = std::numeric_limits<double>::infinity(), high = -low;
      for (const math::Vec3d& corner : piece) {
        low = std::min(low, corner[axis]);
        high = std::max(high, corner[axis]);
      }
      const double first = std::floor((low + kOnGrid) / kGridUnits);
      const double last = std::max(first + 1, std::ceil((high - kOnGrid) / kGridUnits));
      for (double cell = first; cell < last; ++cell) {
        Polygon part = last == first + 1 ? piece
                                         : slice(piece, axis, cell == first ? low : cell * kGridUnits,
                                                 cell + 1 == last ? high : (cell + 1) * kGridUnits);
        if (part.size() >= 3) finer.push_back(std::move(part));
      }
    }
    pieces = std::move(finer);
  }
  return pieces;
}

// A cone over all that a face sees: light falls with the cosine of its angle to the normal, from 1 to 0, or
// to a half.
Cone make_wide_cone(const math::Vec3d& normal, bool ends_at_half) {
  return {math::Vec3(normal), ends_at_half ? -1.0f : 0.0f, 1};
}

// The style and color that a brush gives to the lights on its faces.
LightSource adapt_to_brush(LightSource light, const SurfaceKeys& keys, std::uint8_t switched_style) {
  const auto& [red, green, blue] = keys.surface_light_color;
  if (red >= 0) light.color = {red, green, blue};
  if (keys.surface_light_style >= 0) light.style = static_cast<std::uint8_t>(keys.surface_light_style);
  if (switched_style != 0) light.style = switched_style;
  return light;
}

math::Vec3d compute_polygon_center(const Polygon& polygon) {
  math::Vec3d sum(0.0);
  for (const math::Vec3d& corner : polygon) sum += corner;
  return sum / static_cast<double>(polygon.size());
}

}  // namespace

std::vector<LightSource> find_surface_lights(const LitLevel& lit,
                                             std::span<const SurfaceTemplate> templates) {
  const world::Level& level = *lit.level;
  std::vector<LightSource> lights;
  for (const SurfaceTemplate& shining : templates)
    for (std::size_t number = 0; number < level.faces.size(); ++number) {
      const world::Face& face = level.faces[number];
      if (!base::equal_ignoring_case(level.texture(face.texture).name, shining.texture)) continue;
      const math::Vec3d normal = world::compute_face_plane(level, face).normal;
      const SurfaceKeys& keys = lit.surface_keys(number);
      if (keys.surface_light_group != shining.group) continue;
      LightSource light = adapt_to_brush(shining.light, keys, lit.surface_light_style(number));
      const int rescale = keys.surface_light_rescale >= 0 ? keys.surface_light_rescale : shining.rescale;
      if (light.cone && shining.spotlight) light.cone->direction = math::Vec3(normal);
      if (!light.cone && rescale >= 0) light.cone = make_wide_cone(normal, rescale > 0);
      for (const Polygon& piece : cut_into_pieces(lit.corners_world(number))) {
        light.origin_world = math::Vec3(compute_polygon_center(piece) + normal * double{shining.offset});
        lights.push_back(light);
      }
    }
  return lights;
}

}  // namespace temblor::compiler
