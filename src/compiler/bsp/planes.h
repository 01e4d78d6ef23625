// Every plane of a level once, numbered: number 2k is the plane as the level stores it, 2k + 1 the same plane
// seen from behind.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "math/vec.h"

namespace temblor::compiler {

enum class PlaneIndex : std::uint32_t {};

constexpr PlaneIndex turned(PlaneIndex plane) {
  return static_cast<PlaneIndex>(static_cast<std::uint32_t>(plane) ^ 1u);
}
constexpr PlaneIndex stored(PlaneIndex plane) {
  return static_cast<PlaneIndex>(static_cast<std::uint32_t>(plane) & ~1u);
}
constexpr bool is_turned(PlaneIndex plane) {
  return (static_cast<std::uint32_t>(plane) & 1u) != 0;
}

struct Plane {
  math::Vec3d normal{0.0};
  double distance = 0;
  int axis = 3;  // 0-2: the normal is that axis, either way; 3: any other

  // How far in front of the plane a point lies, in units.
  double distance_to(const math::Vec3d& point) const { return glm::dot(normal, point) - distance; }
};

class PlaneSet {
 public:
  // Planes that differ by less than rounding are one. `normal` has length 1.
  PlaneIndex find_or_add(math::Vec3d normal, double distance);

  const Plane& operator[](PlaneIndex plane) const { return planes_[static_cast<std::uint32_t>(plane)]; }
  std::size_t size() const { return planes_.size(); }  // both ways counted: even

 private:
  std::vector<Plane> planes_;
  std::unordered_multimap<std::int64_t, PlaneIndex> by_distance_;  // stored planes
};

}  // namespace temblor::compiler
