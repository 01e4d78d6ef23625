// Keeps the mix within full scale without distortion: what is too loud is turned down a few milliseconds
// before it comes, and up again slowly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace temblor::audio {

class Limiter {
 public:
  // What comes out is this many frames late.
  static constexpr std::size_t kDelay_frames = 144;  // 3 ms
  static constexpr float kCeiling = 0.99f;

  // Two channels of equal length, in place. Nothing beyond kCeiling comes out, whatever goes in; what is no
  // number is taken for 0.
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

  std::array<float, kDelay_frames> left_{}, right_{};  // on their way
  std::array<float, kDelay_frames> eased_ = filled_with_one();
  std::size_t at_ = 0;  // in these three: the oldest
  double eased_sum_ = kDelay_frames;
  // The needs of the last kDelay_frames that no later, lower one makes superfluous: rising, oldest first, in
  // a circle.
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
