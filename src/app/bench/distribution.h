// What is reported of many measured values.
#pragma once

#include <vector>

namespace temblor::app {

struct Distribution {
  double p50 = 0, p99 = 0, max = 0;
};

// A percentile p is the smallest value that at least p % of the values do not exceed. All 0 for no values.
Distribution distribution_of(std::vector<double> values);

double mean_of(const std::vector<double>& values);

}  // namespace temblor::app
