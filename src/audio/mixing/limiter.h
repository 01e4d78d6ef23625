// Keeps the mix within full scale without distortion: lowers the gain a few milliseconds before a peak and
// raises it again slowly. This is a look-ahead limiter; limiter.cpp describes the method. The original clips
// the mix instead. A mix that stays below the ceiling passes through unchanged, only delayed.
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

  // The factor of the last frame, 0 to 1.
  float gain() const { return gain_; }

 private:
  // The gain that a loud frame needs to stay below the ceiling.
  struct Need {
    std::uint64_t frame;
    float gain;
  };
  // Whether all gains in the average are 1, so that process() can skip the work.
  bool is_at_rest() const { return rest_frames_ >= kDelay_frames; }
  void delay(std::span<float> left, std::span<float> right);
  float compute_next_gain(float peak);
  void add_need(float gain);

  std::array<float, kDelay_frames> left_{}, right_{};  // the delayed samples
  std::array<float, kDelay_frames> eased_ = make_ones();
  std::size_t at_ = 0;  // index of the oldest entry of these three rings
  double eased_sum_ = kDelay_frames;
  // A monotonic queue in a ring: the needs of the last kDelay_frames, without those that a later and lower
  // need makes irrelevant. Gains rise from the oldest to the newest entry, so the oldest is the minimum.
  std::array<Need, kDelay_frames> needs_{};
  std::size_t first_need_ = 0, need_count_ = 0;
  std::uint64_t frame_ = 0;
  float eased_now_ = 1, gain_ = 1;
  std::size_t rest_frames_ = kDelay_frames;  // since eased_now_ was last below 1

  static constexpr std::array<float, kDelay_frames> make_ones() {
    std::array<float, kDelay_frames> ones{};
    ones.fill(1.0f);
    return ones;
  }
};

}  // namespace temblor::audio
