// Tests the limiter: output stays below the ceiling, quiet signals pass unchanged, and the gain never jumps.
#include "audio/mixing/limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "audio/signals.h"
#include "support/random.h"

namespace temblor::test {
namespace {

using audio::Limiter;

// Processes the signal in blocks of random sizes.
void process(Limiter& io_limiter, std::vector<float>& io_left, std::vector<float>& io_right, Random& random) {
  for (std::size_t done = 0; done < io_left.size();) {
    const std::size_t count = std::min(io_left.size() - done, 1 + random.below(400));
    io_limiter.process(std::span(io_left).subspan(done, count), std::span(io_right).subspan(done, count));
    done += count;
  }
}

TEST(Limiter, OnlyDelaysQuietSignals) {
  Random random(1);
  std::vector<float> left(5000), right(5000);
  for (std::size_t i = 0; i < left.size(); ++i) {
    left[i] = static_cast<float>(random.uniform(-0.98, 0.98));
    right[i] = static_cast<float>(random.uniform(-0.98, 0.98));
  }
  const std::vector<float> before_left = left, before_right = right;
  Limiter limiter;
  process(limiter, left, right, random);
  for (std::size_t i = 0; i < left.size(); ++i) {
    const bool is_delay = i < Limiter::kDelay_frames;
    ASSERT_EQ(left[i], is_delay ? 0 : before_left[i - Limiter::kDelay_frames]);
    ASSERT_EQ(right[i], is_delay ? 0 : before_right[i - Limiter::kDelay_frames]);
  }
}

TEST(Limiter, OutputStaysBelowTheCeiling) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    std::vector<float> left(20000), right(20000);
    float loudness = 1;
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (random.chance(0.002)) loudness = static_cast<float>(random.log_uniform(0.01, 1000));
      left[i] = loudness * static_cast<float>(random.uniform(-1, 1));
      right[i] = random.chance(0.001) ? 1e30f : loudness * static_cast<float>(random.uniform(-1, 1));
    }
    Limiter limiter;
    process(limiter, left, right, random);
    EXPECT_LE(peak(left), Limiter::kCeiling) << seed;
    EXPECT_LE(peak(right), Limiter::kCeiling) << seed;
  }
}

// A loud frame in one ear; the quiet constant in the other ear shows the gain.
TEST(Limiter, LowersTheGainBeforeAPeakAndRaisesItSlowly) {
  Random random(3);
  std::vector<float> left(96000, 0.1f), right(96000, 0.1f);
  constexpr std::size_t kLoudAt = 10000;
  right[kLoudAt] = 4;
  Limiter limiter;
  process(limiter, left, right, random);
  const std::size_t out_at = kLoudAt + Limiter::kDelay_frames;
  EXPECT_NEAR(right[out_at], Limiter::kCeiling, 1e-4) << "no lower than necessary";
  EXPECT_NEAR(left[out_at], 0.1 * Limiter::kCeiling / 4, 1e-4) << "the same gain in both ears";
  EXPECT_EQ(left[kLoudAt - 1], 0.1f);
  EXPECT_LT(left[out_at + 2400], 0.09) << "50 ms later";
  EXPECT_GT(left[out_at + 48000], 0.099) << "a second later";
  EXPECT_NEAR(left.back(), 0.1, 1e-4);
  left.erase(left.begin(), left.begin() + Limiter::kDelay_frames);
  EXPECT_LT(largest_step(left), 0.1 / Limiter::kDelay_frames);
}

TEST(Limiter, NonFiniteSamplesBecomeSilence) {
  std::vector<float> left(1000, 0.5f), right(1000, 0.5f);
  left[100] = std::numeric_limits<float>::quiet_NaN();
  right[200] = std::numeric_limits<float>::infinity();
  Limiter limiter;
  limiter.process(left, right);
  EXPECT_EQ(left[100 + Limiter::kDelay_frames], 0);
  EXPECT_EQ(right[200 + Limiter::kDelay_frames], 0);
  EXPECT_EQ(left.back(), 0.5f);
}

}  // namespace
}  // namespace temblor::test
