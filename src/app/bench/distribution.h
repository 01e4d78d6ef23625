// Summaries of measured values: of many frames, and of a few runs.
#pragma once

#include <vector>

namespace temblor::app {

struct Distribution {
  double p50 = 0, p99 = 0, max = 0;
};

// Percentile p is the smallest value that at least p % of the values do not exceed (nearest rank). All 0
// without values.
Distribution compute_distribution(std::vector<double> values);

// A few values: the middle one, or the mean of the two in the middle, and both ends.
struct Spread {
  double median = 0, min = 0, max = 0;
};

// All 0 without values.
Spread compute_spread(std::vector<double> values);

// Returns 0 without values.
double compute_mean(const std::vector<double>& values);

}  // namespace temblor::app
