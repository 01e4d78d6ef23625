// A filter with the resonances (formants) of a mouth, which moves from one vowel to the next.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "artgen/sounds/curve.h"
#include "artgen/sounds/filters.h"
#include "artgen/sounds/signal.h"

namespace temblor::artgen {

// The vowels are given as in "a" or "o..a@0.1..u" (curve.h). Letters: a e i o u, r as in "her", and m for a
// closed mouth.
class VowelFilter {
 public:
  // `size` scales the vocal tract: 1 is a man's, 2 is twice as long, with formants an octave lower. An
  // unknown letter is recorded as a problem.
  VowelFilter(Arguments& io_arguments, std::string_view vowels, double size, double length_s);
  // Filters the signal in place. It may be longer than length_s; the last vowel then stays.
  void apply(Signal& io_signal, double rate) const;

 private:
  // Rows of the table of vowels, in the order of the sequence.
  std::vector<std::size_t> vowels_;
  // The index in vowels_ over time; a fraction means a mixture of two neighbors.
  Curve position_;
  double size_;
};

}  // namespace temblor::artgen
