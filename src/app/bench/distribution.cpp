#include "app/bench/distribution.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace temblor::app {

Distribution compute_distribution(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto percentile = [&](std::size_t percent) {
    // Rounded up; 1 is the smallest value.
    const std::size_t rank = (percent * values.size() + 99) / 100;
    return values[rank - 1];
  };
  return {percentile(50), percentile(99), values.back()};
}

Spread compute_spread(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  return {median, values.front(), values.back()};
}

double compute_mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace temblor::app
