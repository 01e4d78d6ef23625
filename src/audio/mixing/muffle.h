// Muffles sounds under water: a low-pass filter that fades in and out. The original has no such effect. While
// the amount is 0, samples pass through bit for bit.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::audio {

class Muffle {
 public:
  // 0: no change; 1: only frequencies below a few hundred hertz remain. A change from 0 to 1 takes kGlide_s.
  static constexpr float kGlide_s = 0.2f;
  void set_target(float amount) { target_ = amount; }

  // Filters two channels of equal length in place.
  void process(std::span<float> left, std::span<float> right);

 private:
  // The two integrators of one channel.
  struct FilterState {
    float first = 0, second = 0;
  };
  void tune();
  float filter_sample(float sample, FilterState& io_state) const;

  float target_ = 0, amount_ = 0;
  float a1_ = 0, a2_ = 0, a3_ = 0;
  std::uint32_t frame_ = 0;  // since the filter was switched on
  std::array<FilterState, 2> states_{};
};

}  // namespace temblor::audio
