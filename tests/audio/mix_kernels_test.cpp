// Compares the scalar kernel with its definition in double precision, and the SIMD kernel with the scalar
// one.
#include "audio/mixing/mix_kernels.h"

#include <gtest/gtest.h>

#include <vector>

#include "render/simd_targets.h"
#include "support/random.h"

namespace temblor::test {
namespace {

struct Case {
  std::vector<float> samples, left, right;
  audio::MixJob job{};

  explicit Case(Random& random) {
    const std::size_t count = random.below(300);
    const auto any = [&](double size) { return static_cast<float>(random.uniform(-size, size)); };
    for (std::size_t i = 0; i < count; ++i) {
      samples.push_back(any(1));
      left.push_back(any(2));
      right.push_back(any(2));
    }
    job = {nullptr, count, nullptr, nullptr, any(1), any(0.01), any(1), any(0.01)};
  }
  audio::MixJob prepare_job() {
    job.samples = samples.data();
    job.left = left.data();
    job.right = right.data();
    return job;
  }
};

TEST(MixKernel, AddsSamplesWithChangingGains) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const Case before(random);
    Case after = before;
    audio::mix_scalar(after.prepare_job());
    for (std::size_t i = 0; i < before.left.size(); ++i) {
      const auto expected = [&](float own, float gain, float step) {
        return double{own} +
               double{before.samples[i]} * (double{gain} + double{step} * static_cast<double>(i));
      };
      ASSERT_NEAR(after.left[i], expected(before.left[i], before.job.left_gain, before.job.left_step), 1e-6);
      ASSERT_NEAR(after.right[i], expected(before.right[i], before.job.right_gain, before.job.right_step),
                  1e-6);
    }
  }
}

TEST(MixKernel, SimdMatchesScalarBitForBit) {
  for_each_simd_target([] {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      Random random(seed);
      Case scalar(random);
      Case simd = scalar;
      audio::mix_scalar(scalar.prepare_job());
      audio::mix_simd(simd.prepare_job());
      ASSERT_EQ(scalar.left, simd.left) << "seed " << seed;
      ASSERT_EQ(scalar.right, simd.right) << "seed " << seed;
    }
  });
}

}  // namespace
}  // namespace temblor::test
