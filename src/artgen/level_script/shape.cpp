// Convex hulls are found by testing every triple of points in integer arithmetic. Hulls are small (at most 64
// points, mostly 8), and exact results matter more than speed.
#include "artgen/level_script/shape.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace temblor::artgen {
namespace {

using Wide = glm::i64vec3;

Wide cross(Wide a, Wide b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

std::int64_t dot(Wide a, Wide b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Makes normals of parallel planes equal, so that they can be compared.
Wide reduce(Wide normal) {
  const std::int64_t divisor = std::gcd(std::gcd(normal.x, normal.y), normal.z);
  return divisor > 1 ? normal / divisor : normal;
}

// The plane through three points that run clockwise as seen from the front.
HullSide make_hull_side(Point a, Point b, Point c) {
  const Wide normal = cross(Wide(a) - Wide(b), Wide(c) - Wide(b));
  HullSide side{{a, b, c}, reduce(normal), 0};
  side.distance = dot(side.normal, Wide(a));
  return side;
}

// Whether points lie in front of and behind a plane.
struct Sides {
  bool before = false, behind = false;
};

Sides classify_points(const HullSide& side, std::span<const Point> points) {
  Sides found;
  for (const Point& point : points) {
    const std::int64_t off = dot(side.normal, Wide(point)) - side.distance;
    found.before |= off > 0;
    found.behind |= off < 0;
  }
  return found;
}

// Whether the list contains the same plane.
bool is_known(std::span<const HullSide> sides, const HullSide& side) {
  return std::any_of(sides.begin(), sides.end(), [&](const HullSide& known) {
    return known.normal == side.normal && known.distance == side.distance;
  });
}

}  // namespace

Box make_bounding_box(Point a, Point b) {
  return {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

Box grow_box(const Box& box, int by) {
  return {box.low - by, box.high + by};
}

Box intersect(const Box& a, const Box& b) {
  return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
          {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

bool contains(const Box& box, Point point) {
  for (int axis = 0; axis < 3; ++axis)
    if (point[axis] < box.low[axis] || point[axis] > box.high[axis]) return false;
  return true;
}

std::vector<Point> list_corners(const Box& box) {
  std::vector<Point> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({(i & 1) != 0 ? box.high.x : box.low.x, (i & 2) != 0 ? box.high.y : box.low.y,
                       (i & 4) != 0 ? box.high.z : box.low.z});
  return corners;
}

std::vector<Box> subtract(const Box& box, const Box& hole) {
  if (!intersect(box, hole).has_volume()) return {box};
  std::vector<Box> rest;
  Box middle = box;
  // Cut off the parts below and above the hole first, so that floors and ceilings are large pieces.
  for (int axis = 2; axis >= 0; --axis) {
    if (middle.low[axis] < hole.low[axis]) {
      rest.push_back(middle);
      rest.back().high[axis] = hole.low[axis];
      middle.low[axis] = hole.low[axis];
    }
    if (middle.high[axis] > hole.high[axis]) {
      rest.push_back(middle);
      rest.back().low[axis] = hole.high[axis];
      middle.high[axis] = hole.high[axis];
    }
  }
  return rest;
}

std::vector<Box> subtract(const Box& box, std::span<const Box> holes) {
  std::vector<Box> rest = {box};
  for (const Box& hole : holes) {
    std::vector<Box> next;
    for (const Box& piece : rest)
      for (const Box& left : subtract(piece, hole)) next.push_back(left);
    rest = std::move(next);
  }
  return rest;
}

Point Placement::apply(Point point) const {
  if (mirrored) point.x = -point.x;
  for (int i = 0; i < quarter_turns; ++i) point = {-point.y, point.x, point.z};
  return point + origin;
}

Box Placement::apply(const Box& box) const {
  return make_bounding_box(apply(box.low), apply(box.high));
}

double Placement::apply_angle(double yaw_deg) const {
  const double angle = (mirrored ? 180.0 - yaw_deg : yaw_deg) + 90.0 * quarter_turns;
  return angle - 360.0 * std::floor(angle / 360.0);
}

Side Placement::apply(Side side) const {
  if (side == Side::kUp || side == Side::kDown) return side;
  Point direction(0);
  direction[side_axis(side)] = is_upper(side) ? 1 : -1;
  direction = apply(direction) - origin;
  if (direction.x != 0) return direction.x > 0 ? Side::kEast : Side::kWest;
  return direction.y > 0 ? Side::kNorth : Side::kSouth;
}

Placement Placement::operator*(const Placement& inner) const {
  const int turns = mirrored ? 4 - inner.quarter_turns : inner.quarter_turns;
  return {apply(inner.origin), (quarter_turns + turns) % 4, mirrored != inner.mirrored};
}

std::vector<HullSide> make_hull(std::span<const Point> points) {
  std::vector<HullSide> sides;
  for (std::size_t a = 0; a < points.size(); ++a)
    for (std::size_t b = a + 1; b < points.size(); ++b)
      for (std::size_t c = b + 1; c < points.size(); ++c) {
        HullSide side = make_hull_side(points[a], points[b], points[c]);
        if (side.normal == Wide(0)) continue;
        const Sides found = classify_points(side, points);
        // A side of the hull has points on one side only. If all points lie in the plane, the hull has no
        // volume.
        if (found.before == found.behind) continue;
        if (found.before) side = make_hull_side(points[c], points[b], points[a]);
        if (!is_known(sides, side)) sides.push_back(side);
      }
  return sides;
}

Side find_closest_side(glm::i64vec3 normal) {
  const std::int64_t x = std::abs(normal.x), y = std::abs(normal.y), z = std::abs(normal.z);
  if (z >= x && z >= y) return normal.z > 0 ? Side::kUp : Side::kDown;
  if (x >= y) return normal.x > 0 ? Side::kEast : Side::kWest;
  return normal.y > 0 ? Side::kNorth : Side::kSouth;
}

bool is_inside(std::span<const HullSide> hull, Point point) {
  return std::all_of(hull.begin(), hull.end(),
                     [&](const HullSide& side) { return dot(side.normal, Wide(point)) <= side.distance; });
}

bool overlap(std::span<const HullSide> hull, const Box& box) {
  for (const HullSide& side : hull) {
    // The box's corner that lies farthest behind the plane. If it is in front, the plane separates the two.
    Wide deepest(0);
    for (int axis = 0; axis < 3; ++axis)
      deepest[axis] = side.normal[axis] > 0 ? box.low[axis] : box.high[axis];
    if (dot(side.normal, deepest) >= side.distance) return false;
  }
  return true;
}

Box find_bounds(std::span<const Point> points) {
  Box bounds{points.front(), points.front()};
  for (const Point& point : points) {
    bounds.low = make_bounding_box(bounds.low, point).low;
    bounds.high = make_bounding_box(bounds.high, point).high;
  }
  return bounds;
}

}  // namespace temblor::artgen
