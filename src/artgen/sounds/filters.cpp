#include "artgen/sounds/filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace temblor::artgen {
namespace {

// The highest frequency as a fraction of the rate. The tangent grows without bound toward 0.5.
constexpr double kMaxPart = 0.47;

}  // namespace

void StateVariableFilter::set(double frequency, double q, double rate) {
  // Prewarping: the bilinear transform moves frequencies, and the tangent moves this one back.
  g_ = std::tan(std::numbers::pi * std::min(frequency / rate, kMaxPart));
  damping_ = 1 / q;
  scale_ = 1 / (1 + g_ * (g_ + damping_));
}

StateVariableFilter::Bands StateVariableFilter::step(double sample) {
  const double high = (sample - (damping_ + g_) * first_ - second_) * scale_;
  const double band = g_ * high + first_;
  const double low = g_ * band + second_;
  first_ = g_ * high + band;
  second_ = g_ * band + low;
  return {low, band * damping_, high};
}

void OnePoleLowpass::set(double frequency, double rate) {
  part_ = 1 - std::exp(-2 * std::numbers::pi * std::min(frequency / rate, kMaxPart));
}

}  // namespace temblor::artgen
