#include "app/bench/samples.h"

#include <gtest/gtest.h>

namespace temblor::app {
namespace {

constexpr std::size_t kStage = 1;

// One run of frames with these times, each spent in one stage.
Samples make_run(const std::vector<double>& frames_ms) {
  Samples samples;
  for (const double ms : frames_ms) {
    render::FrameStats stats;
    stats.stages.ms[kStage] = ms;
    samples.add(stats);
    samples.client_ms.push_back(0);
    samples.render_ms.push_back(ms);
    samples.present_ms.push_back(0);
    samples.frame_ms.push_back(ms);
    samples.baseline_ms.push_back(1);
  }
  return samples;
}

TEST(Samples, StageTimesAreThoseOfEachFramesFastestRun) {
  Samples samples = make_run({1, 30, 5});
  samples.keep_fastest(make_run({20, 3, 5}));
  samples.keep_fastest(make_run({9, 9, 2}));
  Measurement result;
  samples.summarize(1, result);
  EXPECT_DOUBLE_EQ(result.fps, 1000.0 / 2);
  EXPECT_DOUBLE_EQ(result.stage_ms[kStage], 2);
  EXPECT_EQ(result.slowest_frame, 1u);
}

}  // namespace
}  // namespace temblor::app
