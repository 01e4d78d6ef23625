// The shape of a mouth: a vowel's resonances, from one vowel to the next.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "artgen/sounds/curve.h"
#include "artgen/sounds/filters.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// "a", "o..a@0.1..u": which vowel when. Letters: a e i o u, r (as in "her"), m (the mouth closed).
class Mouth {
 public:
  // `size`: of the throat; 1 is a man's, 2 twice as long. A complaint where a letter is unknown.
  Mouth(Arguments& io_arguments, std::string_view vowels, double size, double length_s);
  void apply(Signal& io_signal, double rate) const;

 private:
  std::vector<std::size_t> vowels_;  // rows of the table
  Curve place_;                      // among them
  double size_;
};

}  // namespace temblor::artgen
