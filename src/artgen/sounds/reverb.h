// Echoes of a room: delays that feed one another (M. Gerzon, 1971; J.-M. Jot, 1991).
#pragma once

#include <array>
#include <cstddef>

#include "artgen/sounds/filters.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

class Reverb {
 public:
  struct Settings {
    double size = 0.3;      // 0: a cupboard, 1: a cathedral
    double ring_s = 1;      // until the echoes have lost 60 dB
    double dull_hz = 4000;  // walls swallow what is above
  };
  struct Echoes {
    double left = 0, right = 0;
  };

  Reverb(const Settings& settings, double rate);
  Echoes step(double sample);

 private:
  static constexpr std::size_t kLines = 8;
  struct Line {
    Signal samples;
    std::size_t at = 0;
    double kept = 0;
    Smoother wall;
  };
  std::array<Line, kLines> lines_;
};

}  // namespace temblor::artgen
