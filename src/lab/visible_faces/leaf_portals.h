// The portals of a level: the openings between neighboring leaves that are not solid.
//
//      +--------+--------+       A node's plane, cut at the planes of the nodes above it, is the opening
//      |  leaf  p  leaf  |       between its two sides. The planes of the nodes below it cut that opening
//      |   1    p   2    |       into a portal for each pair of leaves that touch there.
//      +--------+--------+
//
// The compiler makes portals in the same way, but merges leaves and leaves out narrow openings. These portals
// must not have gaps, because everything behind a gap would be missing in the picture.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/result.h"
#include "world/level.h"

namespace temblor::lab {

struct Portal {
  math::Vec3d normal;                   // of any length; points to leaves[0]
  double distance;                      // normal . p = distance
  math::Vec3d mins, maxs;               // of its corners
  std::array<std::uint32_t, 2> leaves;  // in front, behind
  std::uint32_t first_corner, corner_count;
};

struct LevelPortals {
  std::vector<Portal> portals;
  std::vector<math::Vec3d> corners;  // world space; a convex polygon for each portal, in any direction
  // Portals of leaf i are portal_numbers[leaf_begin[i]] to portal_numbers[leaf_begin[i + 1] - 1].
  std::vector<std::uint32_t> leaf_begin, portal_numbers;
  // Outside of the level, portals end so far from the origin along each axis, in units.
  double extent = 0;

  std::size_t size_bytes() const;
};

// Fails with kTooLarge if the level has more than `max_portals`, or if its tree would take seconds.
base::Result<LevelPortals> make_level_portals(const world::Level& level, std::size_t max_portals);

}  // namespace temblor::lab
