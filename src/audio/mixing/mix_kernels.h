// The mixer's inner loop, as SIMD code and as a scalar reference with the same results. This header has only
// plain types: the SIMD file is compiled once per instruction set.
#pragma once

#include <cstddef>

namespace temblor::audio {

// For i from 0: left[i] += samples[i] * (left_gain + left_step * i); right alike.
struct MixJob {
  const float* samples;
  std::size_t count;  // at most 2^24, so that i is exact as a float
  float* left;
  float* right;
  float left_gain, left_step, right_gain, right_step;
};

// Mixes the samples from `first` on.
void mix_scalar(const MixJob& job, std::size_t first = 0);
void mix_simd(const MixJob& job);

}  // namespace temblor::audio
