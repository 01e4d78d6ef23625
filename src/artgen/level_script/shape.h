// Whole-numbered solid geometry: boxes, convex hulls of points, and where things are put.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

namespace temblor::artgen {

using Point = glm::ivec3;  // map units

// The six ways that a side of a box can face.
enum class Side : std::uint8_t { kEast, kWest, kNorth, kSouth, kUp, kDown };
inline constexpr std::array kSides = {Side::kEast,  Side::kWest, Side::kNorth,
                                      Side::kSouth, Side::kUp,   Side::kDown};
constexpr std::size_t index_of(Side side) {
  return static_cast<std::size_t>(side);
}
constexpr int axis_of(Side side) {
  return static_cast<int>(side) / 2;
}
constexpr bool is_upper(Side side) {
  return static_cast<int>(side) % 2 == 0;
}
constexpr Side opposite(Side side) {
  return static_cast<Side>(static_cast<int>(side) ^ 1);
}

struct Box {
  Point low{0}, high{0};

  Point size() const { return high - low; }
  bool has_volume() const { return low.x < high.x && low.y < high.y && low.z < high.z; }
  int at(Side side) const { return is_upper(side) ? high[axis_of(side)] : low[axis_of(side)]; }
  bool operator==(const Box&) const = default;
};

Box box_around(Point a, Point b);  // two opposite corners, whichever
Box grown(const Box& box, int by);
Box common(const Box& a, const Box& b);  // without a volume where they share none
bool contains(const Box& box, Point point);
std::vector<Point> corners_of(const Box& box);
// What is left of `box`: up to six boxes that do not overlap.
std::vector<Box> without(const Box& box, const Box& hole);
std::vector<Box> without(const Box& box, std::span<const Box> holes);

// Mirrored east to west first, then turned counter-clockwise about the origin, then moved.
struct Placement {
  Point origin{0};
  int quarter_turns = 0;
  bool mirrored = false;

  Point apply(Point point) const;
  Box apply(const Box& box) const;
  double apply_angle(double yaw_deg) const;  // 0 is east, 90 north; the result in [0, 360)
  Side apply(Side side) const;
  Placement operator*(const Placement& inner) const;  // inner first
};

// A side of a hull: what lies behind dot(normal, p) = distance. Through three of the hull's corners, which
// run clockwise seen from in front.
struct HullSide {
  std::array<Point, 3> points{};
  glm::i64vec3 normal{0};
  std::int64_t distance = 0;
};

// The convex hull of at most 64 points within +-16384; each plane once. Empty where they have no volume.
std::vector<HullSide> hull_of(std::span<const Point> points);

// The side of a box that a plane with this normal is most like; up and down before the others.
Side side_like(glm::i64vec3 normal);
bool is_inside(std::span<const HullSide> hull, Point point);   // or on its surface
bool overlap(std::span<const HullSide> hull, const Box& box);  // more than touch; may err for yes
Box bounds_of(std::span<const Point> points);

}  // namespace temblor::artgen
