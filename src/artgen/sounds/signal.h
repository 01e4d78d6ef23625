// What sound is while it is made: samples, one channel, and the noise that is the same every time.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/hash.h"

namespace temblor::artgen {

using Signal = std::vector<double>;  // around -1 to 1; what comes out of a script is brought to level last

// Samples are made at this rate, and files of half that rate are made from it.
constexpr double kSynthesisRate = 44100;

inline std::size_t frames_in(double seconds, double rate) {
  return static_cast<std::size_t>(std::lround(seconds * rate));
}

// Random numbers that depend on the seed alone.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(base::mixed_bits(seed + base::kGoldenGamma)) {}

  // From 0 up to 1.
  double unit() {
    state_ += base::kGoldenGamma;
    return static_cast<double>(base::mixed_bits(state_) >> 11) * 0x1p-53;
  }
  // From -1 up to 1.
  double both() { return 2 * unit() - 1; }
  // From `low` to `high`, as many in each octave.
  double octaves(double low, double high) { return low * std::pow(high / low, unit()); }

 private:
  std::uint64_t state_;
};

}  // namespace temblor::artgen
