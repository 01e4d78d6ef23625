// The planes of a level, each stored once. Plane 2k is the plane as the level stores it, with its normal
// along the positive direction of its main axis; plane 2k + 1 is the same plane facing the other way:
//
//   index    0      1      2      3
//   plane   +x 64  -x -64  +z 0   -z 0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

// The number of a plane in one of its two directions.
enum class PlaneIndex : std::uint32_t {};

// The same plane, facing the other way.
constexpr PlaneIndex flipped(PlaneIndex plane) {
  return static_cast<PlaneIndex>(static_cast<std::uint32_t>(plane) ^ 1u);
}
// Returns the one of the two that the level stores.
constexpr PlaneIndex stored(PlaneIndex plane) {
  return static_cast<PlaneIndex>(static_cast<std::uint32_t>(plane) & ~1u);
}
constexpr bool is_flipped(PlaneIndex plane) {
  return (static_cast<std::uint32_t>(plane) & 1u) != 0;
}

// The points where dot(normal, point) == distance.
struct Plane {
  math::Vec3d normal{0.0};
  double distance = 0;
  int axis = 3;  // 0-2: the normal is along x, y or z, either way; 3: any other direction

  // The point's signed distance in units, positive in front of the plane.
  double distance_to(const math::Vec3d& point) const { return glm::dot(normal, point) - distance; }
};

// Grows while brushes are read; afterwards any number of threads may read it.
class PlaneSet {
 public:
  // Returns the plane's number. Planes that differ by no more than rounding errors get the same one. `normal`
  // has length 1.
  PlaneIndex find_or_add(math::Vec3d normal, double distance);

  const Plane& operator[](PlaneIndex plane) const { return planes_[static_cast<std::uint32_t>(plane)]; }
  std::size_t size() const { return planes_.size(); }  // counts both ways, so it is even

 private:
  std::vector<Plane> planes_;
  std::unordered_multimap<std::int64_t, PlaneIndex> by_distance_;  // stored planes only
};

}  // namespace temblor::compiler
