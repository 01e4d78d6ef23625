// Windings: convex polygons whose corners run clockwise seen from the front of their plane.
#pragma once

#include <vector>

#include "compiler/bsp/planes.h"
#include "math/vec.h"

namespace temblor::compiler {

using Winding = std::vector<math::Vec3d>;

// Points nearer to a plane than this are on it, in units.
constexpr double kOnPlaneEpsilon = 0.01;
// No level reaches farther from the origin, in units.
constexpr double kWorldExtent = 1 << 20;
// An axis-aligned box; empty until something is added.
struct Box {
  math::Vec3d mins{1e30}, maxs{-1e30};

  void add(const math::Vec3d& point) {
    mins = glm::min(mins, point);
    maxs = glm::max(maxs, point);
  }
  void add(const Winding& winding) {
    for (const math::Vec3d& point : winding) add(point);
  }
  bool is_empty() const { return mins.x > maxs.x; }
};

// The distance from a plane, in units, below which points of a winding count as on it. Usually
// kOnPlaneEpsilon, but less if the plane meets the winding's own plane at a small angle: there, everything
// within kOnPlaneEpsilon is a wide strip, and putting that strip on one side as a whole would leave a gap
// between two faces, or draw it twice.
double on_plane_epsilon(const math::Vec3d& winding_normal, const math::Vec3d& plane_normal);

// A square in the plane that reaches beyond `extent` in every direction: what sides and portals are cut from.
Winding make_base_winding(const Plane& plane, double extent = kWorldExtent);

// On which side of a plane a winding is.
enum class WindingSide { kOn, kFront, kBack, kBoth };
// Points within `on_plane` of the plane count as on it.
WindingSide find_side(const Winding& winding, const Plane& plane, double on_plane = kOnPlaneEpsilon);

// The parts in front and behind; either may be empty. A winding on the plane has neither.
struct WindingParts {
  Winding front, back;
};
WindingParts split(const Winding& winding, const Plane& plane, double on_plane = kOnPlaneEpsilon);

// Keeps the part behind the plane, and with `keep_on` a winding on it.
void cut_to_back(Winding& io_winding, const Plane& plane, bool keep_on, double on_plane = kOnPlaneEpsilon);

// Whether the winding is a leftover of rounding: fewer than three of its sides are longer than 0.1 units.
bool is_tiny(const Winding& winding);

double area(const Winding& winding);  // square units

// The distance between the two nearest parallel lines that have the winding between them, in units.
double compute_width(const Winding& winding);

}  // namespace temblor::compiler
