#include "app/bench/distribution.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace temblor::app {

Distribution distribution_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto percentile = [&](std::size_t percent) {
    const std::size_t rank = (percent * values.size() + 99) / 100;  // rounded up, 1 for the smallest
    return values[rank - 1];
  };
  return {percentile(50), percentile(99), values.back()};
}

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace temblor::app
