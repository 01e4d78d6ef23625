// Filters whose frequency may move from sample to sample.
#pragma once

namespace temblor::artgen {

// Two poles, three outputs at once: the trapezoidal state-variable filter (V. Zavalishin, "The Art of VA
// Filter Design", 2012), which stays stable however its frequency moves.
class StateFilter {
 public:
  struct Bands {
    double low = 0, band = 0, high = 0;  // band: 1 at the frequency itself
  };

  // `frequency` is kept below half the rate; q: 0.7 has no peak, 10 rings.
  void set(double frequency, double q, double rate);
  Bands step(double sample);

 private:
  double g_ = 0, damping_ = 1, scale_ = 1;
  double first_ = 0, second_ = 0;
};

// One pole: 6 dB an octave are taken away above the frequency.
class Smoother {
 public:
  void set(double frequency, double rate);
  double step(double sample) { return state_ += part_ * (sample - state_); }

 private:
  double part_ = 1, state_ = 0;
};

}  // namespace temblor::artgen
