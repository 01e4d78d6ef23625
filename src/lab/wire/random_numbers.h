// Random numbers that are the same on every machine.
#pragma once

#include <cstdint>

#include "base/hash.h"

namespace temblor::lab::wire {

// splitmix64; see base/hash.h.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  // In [0, 1).
  double fraction() {
    return static_cast<double>(base::mix_bits(state_ += base::kGoldenGamma) >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace temblor::lab::wire
