#include "app/bench/samples.h"

#include <gtest/gtest.h>

namespace temblor::app {
namespace {

constexpr std::size_t kStage = 1;

// One run of frames that take so long, all of it in one stage.
Samples run_of(const std::vector<double>& frames_ms) {
  Samples samples;
  for (const double ms : frames_ms) {
    render::FrameStats stats;
    stats.stages.ms[kStage] = ms;
    samples.add(stats);
    samples.client_ms.push_back(0);
    samples.render_ms.push_back(ms);
    samples.present_ms.push_back(0);
    samples.frame_ms.push_back(ms);
    samples.floor_ms.push_back(1);
  }
  return samples;
}

TEST(Samples, OfSeveralRunsStagesAreThoseOfEachFramesQuickest) {
  Samples samples = run_of({1, 30, 5});
  samples.keep_quickest(run_of({20, 3, 5}));
  samples.keep_quickest(run_of({9, 9, 2}));
  Measurement result;
  samples.summarize(1, result);
  EXPECT_DOUBLE_EQ(result.fps, 1000.0 / 2);
  EXPECT_DOUBLE_EQ(result.stage_ms[kStage], 2);
  EXPECT_EQ(result.slowest_frame, 1u);
}

}  // namespace
}  // namespace temblor::app
