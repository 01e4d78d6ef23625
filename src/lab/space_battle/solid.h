// The shapes of the space battle: closed solids with flat faces, convex or concave.
//
//        nose                        Seen from above, a solid is an outline around its center. It is widest
//       /    \                       in the middle; above and below, the outline shrinks to the flat faces at
//      / top  \      <- rim          its top and bottom:
//     /__/\__  \                        ______
//    wing    wing                     /________\  <- rim
//                                     \________/
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "math/vec.h"

namespace temblor::lab::space {

// A side of a face runs from `corner` to the corner of the face's next side. Face `neighbor` is beyond it.
struct SolidSide {
  std::uint32_t corner, neighbor;
};

// The sides go clockwise, seen from outside. The face lies on the plane normal . p = distance; the normal has
// length 1 and points out.
struct SolidFace {
  std::uint32_t first_side, side_count;
  math::Vec3d normal;
  double distance;
};

// Around the origin: x is ahead, y left, z up. No corner is farther from the origin than `radius`.
struct Solid {
  std::vector<math::Vec3d> corners;
  std::vector<SolidSide> sides;
  std::vector<SolidFace> faces;
  double radius = 0;

  std::span<const SolidSide> list_sides(const SolidFace& face) const {
    return std::span(sides).subspan(face.first_side, face.side_count);
  }
};

// `outline` goes counterclockwise, seen from above, and every point of it must be visible from the origin. At
// z = half_height and -half_height, it is `shrink` times as large (0 to 1, without both). The solid is convex
// if the outline is, else concave.
Solid make_solid(std::span<const math::Vec2d> outline, double half_height, double shrink);

// The ships and rocks, and a shot; all have a radius of at most 1.
std::vector<Solid> make_convex_ships();
std::vector<Solid> make_concave_ships();
Solid make_shot();

}  // namespace temblor::lab::space
