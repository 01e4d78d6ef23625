// The mixer's inner loop, as vector code and as plain C++ with the same results. Only plain types here: the
// vector file is compiled for several processors.
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

// From sample `first` on.
void mix_scalar(const MixJob& job, std::size_t first = 0);
void mix_simd(const MixJob& job);

}  // namespace temblor::audio
