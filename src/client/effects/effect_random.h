// Random numbers for effects. The same seed gives the same numbers on every machine, so demos look alike
// everywhere; the standard library's distributions would not guarantee that.
#pragma once

#include <cstdint>

#include "base/hash.h"
#include "math/vec.h"

namespace temblor::client {

// The SplitMix64 generator (Steele, Lea and Flood, "Fast Splittable Pseudorandom Number Generators", 2014).
class EffectRandom {
 public:
  explicit EffectRandom(std::uint64_t seed) : state_(seed) {}

  // Returns a number in [0, count); count > 0. Multiplies rather than divides, which is slightly uneven but
  // fast.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((next() >> 32) * count >> 32);
  }
  // Returns a number in [low, high).
  float uniform(float low, float high) {
    return low + (high - low) * (static_cast<float>(next() >> 40) * 0x1p-24f);
  }
  // Returns a point with each component in [-size, size).
  math::Vec3 uniform_in_cube(float size) {
    const float x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }

 private:
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    return base::mix_bits(state_);
  }

  std::uint64_t state_;
};

}  // namespace temblor::client
