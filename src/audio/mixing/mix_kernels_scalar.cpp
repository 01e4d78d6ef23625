// Hot loop. The scalar reference that mix_kernels_simd.cpp must match bit for bit.
#include "audio/mixing/mix_kernels.h"

namespace temblor::audio {

void mix_scalar(const MixJob& job, std::size_t first) {
  for (std::size_t i = first; i < job.count; ++i) {
    const auto place = static_cast<float>(i);
    job.left[i] += job.samples[i] * (job.left_gain + job.left_step * place);
    job.right[i] += job.samples[i] * (job.right_gain + job.right_step * place);
  }
}

}  // namespace temblor::audio
