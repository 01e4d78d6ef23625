// Differences between what a technique shows and what it should.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace temblor::app {

// Their sizes, without signs.
struct Differences {
  double sum = 0, largest = 0;
  std::size_t count = 0;

  void add(double difference) {
    const double size = std::abs(difference);
    sum += size;
    largest = std::max(largest, size);
    ++count;
  }
  double mean() const { return count == 0 ? 0 : sum / static_cast<double>(count); }
};

}  // namespace temblor::app
