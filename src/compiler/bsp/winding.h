// Convex polygons in space, their corners clockwise seen from the front of their plane.
#pragma once

#include <vector>

#include "compiler/bsp/planes.h"
#include "math/vec.h"

namespace temblor::compiler {

using Winding = std::vector<math::Vec3d>;

// Points nearer to a plane than this lie on it, in units.
constexpr double kOnPlane = 0.01;
// No level is larger, from its middle, in units.
constexpr double kWorldExtent = 1 << 20;

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

// How near to a plane is on it, for a winding that lies in a plane of that normal. Where two planes meet at a
// small angle, all that is within kOnPlane of one is a wide strip of the other: taken for one side or the
// other as a whole, it would be a gap between two faces, or drawn twice.
double on_plane_for(const math::Vec3d& winding_normal, const math::Vec3d& plane_normal);

// A square in the plane that reaches beyond `extent` in every direction.
Winding whole_plane(const Plane& plane, double extent = kWorldExtent);

// Where all of a winding lies.
enum class WindingSide { kOn, kFront, kBack, kBoth };
WindingSide side_of(const Winding& winding, const Plane& plane, double on_plane = kOnPlane);

// What lies in front and behind; either may be empty. A winding on the plane goes to neither.
struct WindingParts {
  Winding front, back;
};
WindingParts split(const Winding& winding, const Plane& plane, double on_plane = kOnPlane);

// What lies behind the plane (or on it, where `keep_on`) stays.
void cut_to_back(Winding& io_winding, const Plane& plane, bool keep_on, double on_plane = kOnPlane);

// Whether so little is left that it would only come of rounding: fewer than three sides of some length.
bool is_tiny(const Winding& winding);

double area(const Winding& winding);  // square units

}  // namespace temblor::compiler
