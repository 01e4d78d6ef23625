// Method: each frame needs a gain of at most ceiling / peak. Take the minimum need of the last D frames, let
// it rise only slowly, and average it over D frames; delay the sound by D frames. When a frame leaves the
// delay, all D values in the average already included its need, so the average does not exceed it. An average
// over D values cannot jump.
//
//   in --> peak --> ceiling / peak --> minimum of D --> slow release --> average of D --> gain
//   in --> delay of D frames --------------------------------------------------------> * gain --> out
// (D = kDelay_frames)
#include "audio/mixing/limiter.h"

#include <algorithm>
#include <cmath>

namespace temblor::audio {
namespace {

constexpr float kRelease = 1.0f / (0.15f * 48000);  // share of the way back to 1, per frame
// An exponential approach never arrives, so the gain becomes exactly 1 from here on.
constexpr float kNearOne = 0.9999f;

float finite_or_zero(float sample) {
  return std::isfinite(sample) ? sample : 0;
}

}  // namespace

// Passes the samples through the delay unchanged.
void Limiter::delay(std::span<float> left, std::span<float> right) {
  for (std::size_t i = 0; i < left.size(); ++i) {
    std::swap(left[i], left_[at_]);
    std::swap(right[i], right_[at_]);
    at_ = at_ + 1 == kDelay_frames ? 0 : at_ + 1;
  }
  frame_ += left.size();
}

// Entries with the same or a higher gain expire earlier and can never be the minimum again.
void Limiter::add_need(float gain) {
  while (need_count_ > 0 && needs_[(first_need_ + need_count_ - 1) % kDelay_frames].gain >= gain)
    --need_count_;
  needs_[(first_need_ + need_count_) % kDelay_frames] = {frame_, gain};
  ++need_count_;
}

// Takes the peak of one frame and returns the gain for the frame that leaves the delay.
float Limiter::compute_next_gain(float peak) {
  if (need_count_ > 0 && needs_[first_need_].frame + kDelay_frames <= frame_) {
    first_need_ = (first_need_ + 1) % kDelay_frames;
    --need_count_;
  }
  if (peak > kCeiling) add_need(kCeiling / peak);
  const float lowest = need_count_ > 0 ? needs_[first_need_].gain : 1;
  eased_now_ = std::min(lowest, eased_now_ + (1 - eased_now_) * kRelease);
  if (eased_now_ > kNearOne && lowest == 1) eased_now_ = 1;
  rest_frames_ = eased_now_ < 1 ? 0 : rest_frames_ + 1;
  eased_sum_ += static_cast<double>(eased_now_) - static_cast<double>(eased_[at_]);
  eased_[at_] = eased_now_;
  if (is_at_rest()) eased_sum_ = kDelay_frames;  // removes accumulated rounding errors
  return static_cast<float>(eased_sum_ / kDelay_frames);
}

void Limiter::process(std::span<float> left, std::span<float> right) {
  float peak = 0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = finite_or_zero(left[i]);
    right[i] = finite_or_zero(right[i]);
    peak = std::max(peak, std::max(std::abs(left[i]), std::abs(right[i])));
  }
  if (is_at_rest() && peak <= kCeiling) return delay(left, right);
  for (std::size_t i = 0; i < left.size(); ++i) {
    gain_ = compute_next_gain(std::max(std::abs(left[i]), std::abs(right[i])));
    std::swap(left[i], left_[at_]);
    std::swap(right[i], right_[at_]);
    at_ = at_ + 1 == kDelay_frames ? 0 : at_ + 1;
    ++frame_;
    // The average can exceed the need by a rounding error.
    left[i] = std::clamp(left[i] * gain_, -kCeiling, kCeiling);
    right[i] = std::clamp(right[i] * gain_, -kCeiling, kCeiling);
  }
}

}  // namespace temblor::audio
