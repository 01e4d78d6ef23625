// A two-pole state-variable filter, integrated by the trapezoidal rule (A. Simper, "Linear Trapezoidal
// Integrated State Variable Filter", 2013). It stays stable while its frequency changes.
#include "audio/mixing/muffle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "audio/sound.h"

namespace temblor::audio {
namespace {

// The cutoff frequency at amounts of 0 and 1.
constexpr float kMaxCutoff_hz = 16000, kMinCutoff_hz = 450;
constexpr float kDamping = std::numbers::sqrt2_v<float>;  // a Butterworth filter, without resonance
// tune() computes a power and a tangent, which is too slow for every frame.
constexpr std::uint32_t kTuneEvery_frames = 32;
// Below this amount, the unfiltered sound is still mixed in, so that switching the filter on and off is
// inaudible.
constexpr float kBlendIn = 0.125f;
constexpr float kSilence = 1e-15f;

}  // namespace

// The cutoff frequency falls exponentially with the amount, because pitch is heard on a logarithmic scale.
void Muffle::tune() {
  const float frequency_hz = kMaxCutoff_hz * std::pow(kMinCutoff_hz / kMaxCutoff_hz, amount_);
  const float g = std::tan(std::numbers::pi_v<float> * frequency_hz / kFramesPerSecond);
  a1_ = 1 / (1 + g * (g + kDamping));
  a2_ = g * a1_;
  a3_ = g * a2_;
}

// One step of the filter; returns its low-pass output. Names as in the paper: a1 to a3, band = v1, low = v2.
float Muffle::filter_sample(float sample, FilterState& io_state) const {
  const float rest = sample - io_state.second;
  const float band = a1_ * io_state.first + a2_ * rest;
  const float low = io_state.second + a2_ * io_state.first + a3_ * rest;
  io_state.first = 2 * band - io_state.first;
  io_state.second = 2 * low - io_state.second;
  return low;
}

void Muffle::process(std::span<float> left, std::span<float> right) {
  if (amount_ == 0 && target_ == 0) return;
  constexpr float kStep = 1 / (kGlide_s * kFramesPerSecond);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (frame_++ % kTuneEvery_frames == 0) tune();
    amount_ += std::clamp(target_ - amount_, -kStep, kStep);
    const float share = std::min(1.0f, amount_ / kBlendIn);
    left[i] += share * (filter_sample(left[i], states_[0]) - left[i]);
    right[i] += share * (filter_sample(right[i], states_[1]) - right[i]);
  }
  for (FilterState& state : states_) {
    // Denormal numbers are slow on many processors.
    if (std::abs(state.first) + std::abs(state.second) < kSilence) state = {};
  }
  if (amount_ == 0) {
    states_ = {};
    frame_ = 0;
  }
}

}  // namespace temblor::audio
