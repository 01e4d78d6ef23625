// Walks the trees of a level file in the simplest way, in long double: the reference for the queries of
// src/world.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "formats/levels/bsp.h"

namespace temblor::world {

using Point = std::array<long double, 3>;
Point to_point(const math::Vec3& position);

// Finds the leaf of hull 0 below `node` (a leaf if negative) that contains the point.
std::size_t naive_leaf(const formats::Bsp& bsp, std::int32_t node, const Point& point);

// Finds the contents at a point of hull 0 to 3 of model `model`.
std::int32_t naive_contents(const formats::Bsp& bsp, std::size_t model, std::size_t hull, const Point& point);

// A part of a line, and the leaf of the world that contains it.
struct LeafPiece {
  std::size_t leaf;
  long double length;
};
// Lists the leaves that the line from `start` to `end` passes, in order.
std::vector<LeafPiece> leaves_along(const formats::Bsp& bsp, const Point& start, const Point& end);

}  // namespace temblor::world
