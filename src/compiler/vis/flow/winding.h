// Convex polygons without heap memory: the visibility search cuts them by the million.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "compiler/vis/flow/half_space.h"
#include "math/vec.h"

namespace temblor::compiler::vis {

// In units. Cutting by a plane ignores what sticks out of it by less, so an opening that appears as a slit
// narrower than this counts as closed.
constexpr double kEpsilon = 0.01;

constexpr std::size_t kMaxWindingPoints = 32;

// Only the first `count` points are valid.
struct Winding {
  std::size_t count = 0;
  std::array<math::Vec3d, kMaxWindingPoints> points;

  Winding() = default;
  // `corners`: at most kMaxWindingPoints.
  explicit Winding(std::span<const math::Vec3d> corners) : count(corners.size()) {
    std::copy_n(corners.begin(), count, points.begin());
  }
  // Copies only the corners in use; most windings have four.
  Winding(const Winding& other) { *this = other; }
  Winding& operator=(const Winding& other) {
    count = other.count;
    std::copy_n(other.points.begin(), count, points.begin());
    return *this;
  }

  std::span<const math::Vec3d> corners() const { return {points.data(), count}; }
};

// How much a cut leaves.
enum class Left { kNothing, kSome, kWhole };

// Keeps the part inside the half-space. If nothing is left, the winding is empty. A winding that would get
// more than kMaxWindingPoints corners stays whole: then too much may be seen, never too little.
Left cut(Winding& io_winding, const HalfSpace& keep);

}  // namespace temblor::compiler::vis
