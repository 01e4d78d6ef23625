// Muffles sounds under water: a low-pass filter that fades in and out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::audio {

class Muffle {
 public:
  // 0: no change; 1: only frequencies below a few hundred hertz remain. The filter gets there within
  // kGlide_s.
  static constexpr float kGlide_s = 0.2f;
  void set_target(float amount) { target_ = amount; }

  // Filters two channels of equal length in place.
  void process(std::span<float> left, std::span<float> right);

 private:
  struct Poles {
    float first = 0, second = 0;
  };
  void tune();
  float filtered(float sample, Poles& io_poles) const;

  float target_ = 0, amount_ = 0;
  float a1_ = 0, a2_ = 0, a3_ = 0;
  std::uint32_t frame_ = 0;
  std::array<Poles, 2> poles_{};
};

}  // namespace temblor::audio
