// Filters whose frequency may change with every sample. They are the building blocks of effects, voices, and
// reverb.
#pragma once

namespace temblor::artgen {

// A filter with two poles and three outputs at once, in the trapezoidal (zero-delay feedback) form, which
// stays stable however its frequency moves (V. Zavalishin, "The Art of VA Filter Design", 2012).
class StateVariableFilter {
 public:
  struct Bands {
    // `band` has a gain of 1 at the filter's frequency.
    double low = 0, band = 0, high = 0;
  };

  // Changes the filter and keeps its state. `frequency` is limited to less than half the rate. A q of 0.7 has
  // no peak (Butterworth); 10 rings.
  void set(double frequency, double q, double rate);
  Bands step(double sample);

 private:
  double g_ = 0, damping_ = 1, scale_ = 1;
  double first_ = 0, second_ = 0;
};

// A lowpass with one pole: 6 dB per octave above the frequency.
class OnePoleLowpass {
 public:
  void set(double frequency, double rate);
  double step(double sample) { return state_ += part_ * (sample - state_); }

 private:
  // The fraction of the difference to the input that a step adds; the last output.
  double part_ = 1, state_ = 0;
};

}  // namespace temblor::artgen
