// Frames of stock demos through OpenGL, next to those of the CPU: with models, effects, and the status bar.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "app/demo/demo_run.h"
#include "platform/egl/offscreen_context.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/frames.h"

namespace temblor::app {
namespace {

base::Result<DemoRun> start(const LoadedDemo& demo, RendererKind renderer) {
  return DemoRun::start(demo, {.size = {640, 480}, .threads = {}, .renderer = renderer}, {}, {});
}

class GlDemoFrames : public ::testing::TestWithParam<const char*> {};

// One frame per second; measured: 99.9% of pixels within 2 of 255.
TEST_P(GlDemoFrames, AreThoseOfTheCpu) {
  DATA_FOLDER_OR_SKIP(data);
  if (const auto context = platform::egl::make_offscreen_context(); !context.ok())
    GTEST_SKIP() << "no OpenGL: " << context.error().what;
  const LoadedDemo demo = load_demo({.base_folder = data.string(), .games = {}}, GetParam()).value();
  DemoRun cpu = start(demo, RendererKind::kCpu).value(), gl = start(demo, RendererKind::kGl).value();
  std::vector<double> shares;
  for (double time_s = cpu.scene().time_s + 0.5;
       shares.size() < static_cast<std::size_t>(test::effort(10000, 3)); ++time_s) {
    const base::Result<bool> has_more = cpu.advance_to(time_s);
    ASSERT_TRUE(has_more.ok());
    ASSERT_TRUE(gl.advance_to(time_s).ok());
    ASSERT_TRUE(cpu.draw().ok());
    ASSERT_TRUE(gl.draw().ok());
    shares.push_back(test::equal_share(cpu.frame().rgb(), gl.frame().rgb(), 2));
    if (!*has_more) break;
  }
  double total = 0;
  for (const double share : shares) total += share;
  const double mean = total / static_cast<double>(shares.size());
  const double worst = *std::ranges::min_element(shares);
  std::cout << "[          ] " << GetParam() << ": " << shares.size() << " frames, equal " << mean
            << ", worst " << worst << "\n";
  EXPECT_GE(mean, test::kQuick ? 0.99 : 0.998);  // the mean of three frames says little
  EXPECT_GE(worst, 0.99);
}

INSTANTIATE_TEST_SUITE_P(Demos, GlDemoFrames, ::testing::Values("demo1_lite", "demo2_lite", "demo3_lite"));

}  // namespace
}  // namespace temblor::app
