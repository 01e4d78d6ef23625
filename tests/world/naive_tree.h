// The trees of a level file walked in the plainest way, in long double: what the world's queries are held
// against.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "formats/levels/bsp.h"

namespace temblor::world {

using Point = std::array<long double, 3>;
Point to_point(const math::Vec3& position);

// The leaf of hull 0 below `node` (a leaf when negative) that holds the point.
std::size_t naive_leaf(const formats::Bsp& bsp, std::int32_t node, const Point& point);

// The contents of model `model`'s hull 0 to 3 at the point.
std::int32_t naive_contents(const formats::Bsp& bsp, std::size_t model, std::size_t hull, const Point& point);

// Part of a line and the world's leaf that it lies in.
struct LeafPiece {
  std::size_t leaf;
  long double length;
};
// The leaves that the line from `start` to `end` passes, in order.
std::vector<LeafPiece> leaves_along(const formats::Bsp& bsp, const Point& start, const Point& end);

}  // namespace temblor::world
