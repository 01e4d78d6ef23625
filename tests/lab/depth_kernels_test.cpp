// The depth test's SIMD versions against the scalar one.
#include "lab/hidden_surfaces/depth_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "render/simd_targets.h"
#include "support/effort.h"
#include "support/random.h"

namespace temblor::test {
namespace {

struct Tested {
  std::vector<float> depth;
  std::vector<std::pair<std::int32_t, std::int32_t>> runs;
  bool operator==(const Tested&) const = default;
};

using TestDepth = std::int32_t (*)(const lab::DepthSpan&, lab::PixelRun*);

Tested run_test(TestDepth test_depth, std::vector<float> depth, lab::DepthSpan span) {
  std::vector<lab::PixelRun> runs(static_cast<std::size_t>(span.count + 1) / 2);
  depth.insert(depth.begin(), 0.0f);  // rows begin anywhere, also between the addresses of vectors
  span.depth = depth.data() + 1;
  const std::int32_t count = test_depth(span, runs.data());
  depth.erase(depth.begin());
  Tested tested{std::move(depth), {}};
  for (std::int32_t i = 0; i < count; ++i) {
    const lab::PixelRun& run = runs[static_cast<std::size_t>(i)];
    tested.runs.emplace_back(run.begin, run.end);
  }
  return tested;
}

TEST(DepthKernels, FindTheSameRunsAndDepths) {
  for (int seed = 0; seed < effort(2000, 200); ++seed) {
    SCOPED_TRACE(seed);
    Random random(static_cast<std::uint64_t>(seed));
    lab::DepthSpan span{nullptr, static_cast<std::int32_t>(1 + random.below(80)),
                        static_cast<float>(random.uniform(0, 1)),
                        static_cast<float>(random.uniform(-0.02, 0.02))};
    std::vector<float> depth(static_cast<std::size_t>(span.count) + lab::kDepthPadding);
    const double share_empty = random.uniform(0, 1);
    for (float& value : depth)
      value = random.chance(share_empty) ? std::numeric_limits<float>::lowest()
                                         : static_cast<float>(random.uniform(0, 1));
    // Equal depths do not pass.
    if (random.chance(0.3)) depth[0] = span.first;
    const Tested scalar = run_test(lab::test_depth_scalar, depth, span);
    for (std::size_t i = 0; i < static_cast<std::size_t>(span.count); ++i) {
      const float product = span.step * static_cast<float>(i);
      const float own = span.first + product;
      const bool in_run = std::ranges::any_of(scalar.runs, [&](const auto& run) {
        return run.first <= static_cast<std::int32_t>(i) && static_cast<std::int32_t>(i) < run.second;
      });
      EXPECT_EQ(in_run, own > depth[i]);
      EXPECT_EQ(scalar.depth[i], std::max(own, depth[i]));
    }
    for_each_simd_target([&] { EXPECT_EQ(run_test(lab::test_depth_simd, depth, span), scalar); });
  }
}

}  // namespace
}  // namespace temblor::test
