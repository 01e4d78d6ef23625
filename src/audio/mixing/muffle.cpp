// A two-pole state-variable filter, integrated by the trapezoidal rule (A. Simper, "Linear Trapezoidal
// Integrated State Variable Filter", 2013). It stays stable while its frequency changes.
#include "audio/mixing/muffle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "audio/sound.h"

namespace temblor::audio {
namespace {

constexpr float kHighest_hz = 16000, kLowest_hz = 450;
constexpr float kDamping = std::numbers::sqrt2_v<float>;  // no resonance
constexpr std::uint32_t kTuneEvery_frames = 32;
// Below this amount, the unfiltered sound is still mixed in, so that switching the filter on and off is
// inaudible.
constexpr float kBlendIn = 0.125f;
constexpr float kSilence = 1e-15f;

}  // namespace

// Moves the cutoff frequency. Equal steps of the amount are equal musical intervals.
void Muffle::tune() {
  const float frequency_hz = kHighest_hz * std::pow(kLowest_hz / kHighest_hz, amount_);
  const float g = std::tan(std::numbers::pi_v<float> * frequency_hz / kFramesPerSecond);
  a1_ = 1 / (1 + g * (g + kDamping));
  a2_ = g * a1_;
  a3_ = g * a2_;
}

// Filters one sample of one ear; the low-pass output of the filter is used.
float Muffle::filtered(float sample, Poles& io_poles) const {
  const float rest = sample - io_poles.second;
  const float band = a1_ * io_poles.first + a2_ * rest;
  const float low = io_poles.second + a2_ * io_poles.first + a3_ * rest;
  io_poles.first = 2 * band - io_poles.first;
  io_poles.second = 2 * low - io_poles.second;
  return low;
}

void Muffle::process(std::span<float> left, std::span<float> right) {
  if (amount_ == 0 && target_ == 0) return;
  constexpr float kStep = 1 / (kGlide_s * kFramesPerSecond);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (frame_++ % kTuneEvery_frames == 0) tune();
    amount_ += std::clamp(target_ - amount_, -kStep, kStep);
    const float share = std::min(1.0f, amount_ / kBlendIn);
    left[i] += share * (filtered(left[i], poles_[0]) - left[i]);
    right[i] += share * (filtered(right[i], poles_[1]) - right[i]);
  }
  for (Poles& poles : poles_) {
    // Denormal numbers are slow on many processors.
    if (std::abs(poles.first) + std::abs(poles.second) < kSilence) poles = {};
  }
  if (amount_ == 0) {
    poles_ = {};
    frame_ = 0;
  }
}

}  // namespace temblor::audio
