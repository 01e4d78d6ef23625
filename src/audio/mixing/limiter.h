// Keeps the mix within full scale without distortion: lowers the gain a few milliseconds before a peak and
// raises it again slowly. The method is described in limiter.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::audio {

class Limiter {
 public:
  // The output is this many frames late.
  static constexpr std::size_t kDelay_frames = 144;  // 3 ms
  static constexpr float kCeiling = 0.99f;

  // Processes two channels of equal length in place. No output sample exceeds kCeiling; NaN counts as 0.
  void process(std::span<float> left, std::span<float> right);

  // The factor in use, 0 to 1.
  float gain() const { return gain_; }

 private:
  struct Need {
    std::uint64_t frame;
    float gain;
  };
  bool is_at_rest() const { return rest_frames_ >= kDelay_frames; }
  void delay(std::span<float> left, std::span<float> right);
  float next_gain(float peak);
  void add_need(float gain);

  std::array<float, kDelay_frames> left_{}, right_{};  // the delayed samples
  std::array<float, kDelay_frames> eased_ = filled_with_one();
  std::size_t at_ = 0;  // index of the oldest entry of these three rings
  double eased_sum_ = kDelay_frames;
  // A monotonic queue in a ring: the needs of the last kDelay_frames, without those that a later and lower
  // need makes irrelevant. Gains rise from the oldest to the newest entry.
  std::array<Need, kDelay_frames> needs_{};
  std::size_t first_need_ = 0, need_count_ = 0;
  std::uint64_t frame_ = 0;
  float eased_now_ = 1, gain_ = 1;
  std::size_t rest_frames_ = kDelay_frames;  // since eased_now_ was last below 1

  static constexpr std::array<float, kDelay_frames> filled_with_one() {
    std::array<float, kDelay_frames> ones{};
    ones.fill(1.0f);
    return ones;
  }
};

}  // namespace temblor::audio
