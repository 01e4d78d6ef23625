// Solid geometry with integer coordinates: boxes, convex hulls of points, and placements. Everything is
// exact, so brushes that touch in a script also touch in the map.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace temblor::artgen {

// In map units.
using Point = glm::ivec3;

// The six directions that a side of a box can face: +x, -x, +y, -y, +z, -z.
enum class Side : std::uint8_t { kEast, kWest, kNorth, kSouth, kUp, kDown };
inline constexpr std::array kSides = {Side::kEast,  Side::kWest, Side::kNorth,
                                      Side::kSouth, Side::kUp,   Side::kDown};
// For arrays with one element per side.
constexpr std::size_t side_index(Side side) {
  return static_cast<std::size_t>(side);
}
// 0, 1, or 2.
constexpr int side_axis(Side side) {
  return static_cast<int>(side) / 2;
}
// Whether it is the side with the larger coordinate.
constexpr bool is_upper(Side side) {
  return static_cast<int>(side) % 2 == 0;
}
constexpr Side opposite(Side side) {
  return static_cast<Side>(static_cast<int>(side) ^ 1);
}

// An axis-aligned box from `low` to `high`.
struct Box {
  Point low{0}, high{0};

  Point size() const { return high - low; }
  bool has_volume() const { return low.x < high.x && low.y < high.y && low.z < high.z; }
  // The coordinate of a side on its axis.
  int at(Side side) const { return is_upper(side) ? high[side_axis(side)] : low[side_axis(side)]; }
  bool operator==(const Box&) const = default;
};

// From any two opposite corners.
Box make_bounding_box(Point a, Point b);
// Moves all sides outward by `by`.
Box grow_box(const Box& box, int by);
// The common part; without a volume if there is none.
Box intersect(const Box& a, const Box& b);
// Whether the point is inside or on the surface.
bool contains(const Box& box, Point point);
std::vector<Point> list_corners(const Box& box);
// Returns the rest of `box`: up to six boxes per hole, which do not overlap.
std::vector<Box> subtract(const Box& box, const Box& hole);
std::vector<Box> subtract(const Box& box, std::span<const Box> holes);

// A rigid transform: mirrors x, then rotates counter-clockwise about the origin, then moves. Scripts use it
// to place groups.
struct Placement {
  Point origin{0};
  int quarter_turns = 0;
  bool mirrored = false;

  Point apply(Point point) const;
  Box apply(const Box& box) const;
  // 0 is east, 90 north; the result is in [0, 360).
  double apply_angle(double yaw_deg) const;
  Side apply(Side side) const;
  // The placement that applies `inner` first.
  Placement operator*(const Placement& inner) const;
};

// A side of a convex hull: the plane dot(normal, p) = distance, with the hull behind it. `points` are three
// of the hull's corners, clockwise as seen from the front, as MAP files define planes.
struct HullSide {
  std::array<Point, 3> points{};
  glm::i64vec3 normal{0};
  std::int64_t distance = 0;
};

// The convex hull of at most 64 points within +-16384, with each plane once. Empty if the points have no
// volume.
std::vector<HullSide> make_hull(std::span<const Point> points);

// The side of a box that a normal is closest to. Ties prefer up and down.
Side find_closest_side(glm::i64vec3 normal);
// Whether the point is inside or on the surface.
bool is_inside(std::span<const HullSide> hull, Point point);
// Whether they overlap by more than a touch. Conservative: it may return true for a near miss at an edge.
bool overlap(std::span<const HullSide> hull, const Box& box);
// `points` must not be empty.
Box find_bounds(std::span<const Point> points);

}  // namespace temblor::artgen
