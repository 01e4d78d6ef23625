#include "compiler/bsp/outside/wedge.h"

#include <algorithm>
#include <limits>

namespace temblor::compiler {
namespace {

// The cosine of 2 degrees. At a larger angle, the narrow part is shorter than three units.
constexpr double kMinFlatness = 0.9994;

// The distance between the planes at a point, for planes that face away from each other, is linear:
// (d0 + d1) - (n0 + n1) * point. So a plane divides the wide part from the narrow one.
std::optional<Wedge> make_wedge(const LeafPlane& first, const LeafPlane& second,
                                std::span<const math::Vec3d> corners, double min_opening_units) {
  const Plane &a = first.plane, &b = second.plane;
  if (glm::dot(a.normal, b.normal) > -kMinFlatness) return std::nullopt;
  double narrowest = std::numeric_limits<double>::max(), widest = -narrowest;
  for (const math::Vec3d& corner : corners) {
    const double width = -a.distance_to(corner) - b.distance_to(corner);
    narrowest = std::min(narrowest, width);
    widest = std::max(widest, width);
  }
  if (narrowest >= min_opening_units || widest < min_opening_units) return std::nullopt;
  const math::Vec3d narrowing = a.normal + b.normal;
  const double angle = glm::length(narrowing);
  if (angle == 0) return std::nullopt;  // parallel: as wide everywhere, except for rounding
  Wedge wedge{{first.node, second.node}, {}};
  wedge.limit.normal = narrowing / angle;
  wedge.limit.distance = (a.distance + b.distance - min_opening_units) / angle;
  return wedge;
}

}  // namespace

std::optional<Wedge> find_wedge(std::span<const LeafPlane> planes, std::span<const math::Vec3d> corners,
                                double min_opening_units) {
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (auto wedge = make_wedge(planes[i], planes[k], corners, min_opening_units)) return wedge;
  return std::nullopt;
}

}  // namespace temblor::compiler
