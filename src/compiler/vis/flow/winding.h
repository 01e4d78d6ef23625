// Convex polygons without heap memory, as the flow through portals cuts them by the million.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "compiler/vis/flow/half_space.h"
#include "math/vec.h"

namespace temblor::compiler::vis {

// Units. What would stand out of a plane by less than this is gone when the plane cuts: an opening that
// shows as a slit narrower than this counts as shut.
constexpr double kEpsilon = 0.01;

constexpr std::size_t kMaxWindingPoints = 32;

struct Winding {
  std::size_t count = 0;
  std::array<math::Vec3d, kMaxWindingPoints> points;

  Winding() = default;
  // Copies what is used: most windings have four corners.
  Winding(const Winding& other) { *this = other; }
  Winding& operator=(const Winding& other) {
    count = other.count;
    std::copy_n(other.points.begin(), count, points.begin());
    return *this;
  }

  std::span<const math::Vec3d> corners() const { return {points.data(), count}; }
};

// Leaves what lies in the half-space. False, and the winding empty, when nothing does. A winding that would
// get more than kMaxWindingPoints corners stays whole: more may be seen, never less.
bool cut(Winding& io_winding, const HalfSpace& keep);

}  // namespace temblor::compiler::vis
