// Method: for each edge, the plane through it turns about the edge, from the far side, until it touches the
// other polygon. The corner with the smallest angle is found by comparing fractions, without any
// trigonometry.
#include "compiler/vis/flow/separators.h"

#include <algorithm>
#include <cmath>

namespace temblor::compiler::vis {

namespace {

using math::Vec3d;

// A corner of the other polygon as seen along an edge of the first one. The edge is the origin, and the first
// polygon is a line to its left.
struct Profile {
  double outward = 0, up = 0;
};

class EdgePlanes {
 public:
  // `side` is 1 if the other polygon is in front of this one's plane, -1 if it is behind.
  EdgePlanes(PlanarWinding own, const Winding& other, double side)
      : own_(own.winding), other_(other), normal_(own.plane.normal), side_(side) {
    for (std::size_t i = 0; i < other.count; ++i) {
      heights_[i] = side * own.plane.above(other.points[i]);
      lowest_ = std::min(lowest_, heights_[i]);
      heights_[i] = std::max(heights_[i], 0.0);
    }
  }

  bool apart() const { return lowest_ >= -kEpsilon; }

  // Finds the plane through the edge with own_ outside and all of other_ inside. Returns false if there is
  // none.
  bool find(std::size_t edge_index, HalfSpace& out_plane) const {
    const Vec3d& start = own_.points[edge_index];
    const Vec3d edge = own_.points[edge_index + 1 == own_.count ? 0 : edge_index + 1] - start;
    const double squared = glm::dot(edge, edge);
    if (squared < kEpsilon * kEpsilon) return false;
    const Vec3d outward = glm::cross(normal_, edge) / std::sqrt(squared);
    const Profile touched = outermost(outward, glm::dot(outward, start));
    // The polygon's own plane separates nothing.
    if (touched.up == 0) return false;
    const double distance = std::sqrt(touched.outward * touched.outward + touched.up * touched.up);
    out_plane.normal = outward * (touched.up / distance) - normal_ * (side_ * touched.outward / distance);
    out_plane.distance = glm::dot(out_plane.normal, start);
    return true;
  }

 private:
  // A plane that turns about the edge, starting in the polygon's own plane, meets this corner last. If a
  // corner is in that plane on the polygon's side, it cannot turn at all.
  Profile outermost(const Vec3d& outward, double start_outward) const {
    Profile found;
    for (std::size_t i = 0; i < other_.count; ++i) {
      const Profile corner{glm::dot(outward, other_.points[i]) - start_outward, heights_[i]};
      if (corner.up < kEpsilon) {
        if (corner.outward <= -kEpsilon) return {};
        // A corner on the edge's own line is in every plane.
        if (corner.outward < kEpsilon) continue;
      }
      const bool is_first = found.outward == 0 && found.up == 0;
      if (is_first || found.outward * corner.up > found.up * corner.outward) found = corner;
    }
    return found;
  }

  const Winding& own_;
  const Winding& other_;
  const Vec3d& normal_;
  double side_;
  double lowest_ = 0;
  std::array<double, kMaxWindingPoints> heights_;
};

}  // namespace

void find_separators(PlanarWinding source, PlanarWinding pass, Separators& out_separators) {
  out_separators.count = 0;
  const EdgePlanes from_source(source, pass.winding, 1);
  const EdgePlanes from_pass(pass, source.winding, -1);
  if (!from_source.apart() || !from_pass.apart()) return;
  HalfSpace plane;
  for (std::size_t i = 0; i < source.winding.count; ++i)
    if (from_source.find(i, plane)) out_separators.planes[out_separators.count++] = plane;
  for (std::size_t i = 0; i < pass.winding.count; ++i)
    if (from_pass.find(i, plane)) out_separators.planes[out_separators.count++] = plane.flipped();
}

}  // namespace temblor::compiler::vis
