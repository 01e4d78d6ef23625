// Random numbers for property tests: the same on every machine and with every library, from a seed that a
// failing test prints.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "math/vec.h"

namespace temblor::test {

// splitmix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    return mixed ^ (mixed >> 31);
  }
  // In [0, count); count > 0. The bias of the remainder is below 2^-32 for the counts that tests use.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  // In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  // In [low, high), with a uniform logarithm; 0 < low < high.
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  // Each component in [-size, size).
  math::Vec3 in_cube(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return math::Vec3(math::Vec3d(x, y, z));
  }

 private:
  std::uint64_t state_;
};

}  // namespace temblor::test
