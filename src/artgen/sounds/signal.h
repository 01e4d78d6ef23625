// The representation of sound during synthesis: one channel of samples, and a source of random numbers. All
// random numbers come from seeds, so the same script makes the same sound.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/hash.h"

namespace temblor::artgen {

// Samples, usually between -1 and 1. Intermediate signals may exceed that; mastering.h normalizes them at the
// end.
using Signal = std::vector<double>;

// The rate in samples per second at which sounds are made. Files with half that rate are derived from it.
constexpr double kSynthesisRate = 44100;

// The number of samples that last so long, rounded.
inline std::size_t count_frames(double seconds, double rate) {
  return static_cast<std::size_t>(std::lround(seconds * rate));
}

// A generator of random numbers that depend only on the seed (SplitMix64).
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(base::mix_bits(seed + base::kGoldenGamma)) {}

  // Uniform in [0, 1).
  double unit() {
    state_ += base::kGoldenGamma;
    return static_cast<double>(base::mix_bits(state_) >> 11) * 0x1p-53;
  }
  // Uniform in [-1, 1).
  double bipolar() { return 2 * unit() - 1; }
  // From `low` to `high`, with the same probability for each octave. Both must be above 0.
  double log_uniform(double low, double high) { return low * std::pow(high / low, unit()); }

 private:
  std::uint64_t state_;
};

}  // namespace temblor::artgen
