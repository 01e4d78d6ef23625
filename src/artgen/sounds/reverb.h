// Reverberation by a feedback delay network: eight delay lines, each with a lowpass, that feed each other
// through an orthogonal matrix (M. Gerzon, 1971; J.-M. Jot, 1991).
//
//   input --+--> line 0 --> lowpass --> gain --+--> left and right output
//           |      ...                         |
//           +--> line 7 --> lowpass --> gain --+
//           |                                  |
//           '------------ Householder matrix --'
#pragma once

#include <array>
#include <cstddef>

#include "artgen/sounds/filters.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

class Reverb {
 public:
  struct Settings {
    // 0 is a cupboard, 1 a cathedral. It determines the delays.
    double size = 0.3;
    // The time in which echoes lose 60 dB.
    double ring_s = 1;
    // Walls absorb frequencies above this.
    double damping_hz = 4000;
  };
  // One stereo sample of the reverberation, without the input.
  struct Echoes {
    double left = 0, right = 0;
  };

  Reverb(const Settings& settings, double rate);
  Echoes step(double sample);

 private:
  static constexpr std::size_t kLines = 8;
  // A delay line as a ring buffer. `at` is the position of its oldest sample, which the next one replaces.
  struct Line {
    Signal samples;
    std::size_t at = 0;
    double gain = 0;
    OnePoleLowpass lowpass;
  };
  std::array<Line, kLines> lines_;
};

}  // namespace temblor::artgen
