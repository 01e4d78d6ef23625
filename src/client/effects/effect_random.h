// Chance in effects: the same on every machine, from a seed.
#pragma once

#include <cstdint>

#include "base/hash.h"
#include "math/vec.h"

namespace temblor::client {

// splitmix64.
class EffectRandom {
 public:
  explicit EffectRandom(std::uint64_t seed) : state_(seed) {}

  // In [0, count); count > 0.
  std::uint32_t below(std::uint32_t count) {
    return static_cast<std::uint32_t>((next() >> 32) * count >> 32);
  }
  // In [low, high).
  float uniform(float low, float high) {
    return low + (high - low) * (static_cast<float>(next() >> 40) * 0x1p-24f);
  }
  // Each component in [-size, size).
  math::Vec3 in_cube(float size) {
    const float x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }

 private:
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    return base::mixed_bits(state_);
  }

  std::uint64_t state_;
};

}  // namespace temblor::client
