// Separators: the planes that bound what can be seen from one polygon through another (Airey, "Increasing
// Update Rates in the Building Walkthrough System", 1990; Teller, "Visibility Computations in Densely
// Occluded Polyhedral Environments", 1992).
//
//   source  \     / pass      Each separator touches an edge of one polygon
//            \   /            and a corner of the other. Nothing outside of
//             \ /             it can be seen from source through pass.
//              X
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "compiler/vis/flow/winding.h"

namespace temblor::compiler::vis {

// A fixed-size list of half-spaces.
struct Separators {
  std::size_t count = 0;
  std::array<HalfSpace, 2 * kMaxWindingPoints> planes;

  std::span<const HalfSpace> all() const { return {planes.data(), count}; }
};

// A part of an opening in the opening's plane; corners are clockwise seen from in front.
struct PlanarWinding {
  const Winding& winding;
  const HalfSpace& plane;
};

// Finds the planes through an edge of one polygon and a corner of the other, with `source` outside and `pass`
// inside the half-space; there is at most one for each edge. Everything beyond `pass` and outside any of them
// cannot be seen from `source`. Finds fewer, so that more is seen, if the polygons reach over each other's
// planes by more than kEpsilon, or for edges that are shorter than that.
void find_separators(PlanarWinding source, PlanarWinding pass, Separators& out_separators);

}  // namespace temblor::compiler::vis
