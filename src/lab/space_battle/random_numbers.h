// Random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/hash.h"

namespace temblor::lab::space {

// splitmix64; see base/hash.h.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  // In [low, high).
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }
  // In [0, count); count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }

 private:
  std::uint64_t next() { return base::mix_bits(state_ += base::kGoldenGamma); }

  std::uint64_t state_;
};

}  // namespace temblor::lab::space
