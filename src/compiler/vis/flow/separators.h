// The planes that bound what can be seen from one polygon through another (Airey, "Increasing Update Rates
// in the Building Walkthrough System", 1990; Teller, "Visibility Computations in Densely Occluded Polyhedral
// Environments", 1992).
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "compiler/vis/flow/winding.h"

namespace temblor::compiler::vis {

struct Separators {
  std::size_t count = 0;
  std::array<HalfSpace, 2 * kMaxWindingPoints> planes;

  std::span<const HalfSpace> all() const { return {planes.data(), count}; }
};

// A polygon, part of an opening, in the opening's plane; corners clockwise seen from in front of it.
struct PlanarWinding {
  const Winding& winding;
  const HalfSpace& plane;
};

// Each plane found holds an edge of one polygon and a corner of the other, with `source` outside and `pass`
// inside the half-space: what lies beyond `pass` and outside any of them cannot be seen from `source`. For
// each edge there is one such plane at most. Where polygons reach over each other's planes by more than
// kEpsilon, or an edge is shorter than that, it is left out, and more is seen.
void find_separators(PlanarWinding source, PlanarWinding pass, Separators& out_separators);

}  // namespace temblor::compiler::vis
