// The mixer's inner loop, as SIMD code and as a scalar reference with the same results. This header has only
// plain types: the SIMD file is compiled once per instruction set.
#pragma once

#include <cstddef>

namespace temblor::audio {

// Adds one sound to both ears, with gains that change linearly. For each i from 0 to count - 1:
//   left[i]  += samples[i] * (left_gain  + left_step  * i)
//   right[i] += samples[i] * (right_gain + right_step * i)
// The buffers must not overlap. They need no alignment.
struct MixJob {
  const float* samples;
  std::size_t count;  // at most 2^24, so that i is exact as a float
  float* left;
  float* right;
  float left_gain, left_step, right_gain, right_step;
};

// Mixes the samples from index `first` on; the SIMD version uses it for the last incomplete vector.
void mix_scalar(const MixJob& job, std::size_t first = 0);
void mix_simd(const MixJob& job);

}  // namespace temblor::audio
