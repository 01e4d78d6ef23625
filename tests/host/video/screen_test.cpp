// The end of a frame: tone, dynamic resolution, frame rate.
#include "host/video/screen.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "host/session/worker.h"
#include "platform/headless/window.h"

namespace temblor::host {
namespace {

TEST(Tone, NeutralChangesNothing) {
  const ToneTable table = make_tone_table({});
  for (std::size_t i = 0; i < table.size(); ++i) EXPECT_EQ(table[i], i);
}

// The stock table: 255 * ((i + 0.5) / 255.5) ^ gamma + 0.5.
TEST(Tone, GammaFollowsTheStockCurve) {
  const ToneTable table = make_tone_table({.gamma = 0.7f});
  for (const int i : {0, 1, 17, 128, 254, 255})
    EXPECT_NEAR(table[static_cast<std::size_t>(i)], 255 * std::pow((i + 0.5) / 255.5, 0.7) + 0.5, 1) << i;
}

TEST(Tone, AppliesTheTableToAllChannels) {
  const ToneTable table = make_tone_table({.gamma = 0.6f, .contrast = 1.2f, .brightness = 0.05f});
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < 1001; ++i) pixels.push_back(0xff000000u | i * 16411);
  const std::vector<std::uint32_t> before = pixels;
  base::Jobs jobs(2, base::JobBackend::kStdThread);
  apply_tone(table, jobs, pixels);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    for (const int shift : {0, 8, 16})
      ASSERT_EQ(pixels[i] >> shift & 255, table[before[i] >> shift & 255]) << i;
}

// If drawing time is proportional to the number of pixels, the scale must settle at a value that holds the
// target.
TEST(AutomaticScale, HoldsTheTargetAndSettles) {
  for (const double whole_frame_s : {0.010, 0.020, 0.030, 0.050}) {
    AutomaticScale scale;
    constexpr double kTarget_s = 1.0 / 60;
    const auto drawing_s = [&] { return whole_frame_s * static_cast<double>(scale.scale() * scale.scale()); };
    for (int i = 0; i < 600; ++i) scale.update(drawing_s(), kTarget_s);
    const float settled = scale.scale();
    if (settled > AutomaticScale::kMinScale) {
      EXPECT_LE(drawing_s(), kTarget_s);
    }
    for (int i = 0; i < 600; ++i) {
      scale.update(drawing_s(), kTarget_s);
      EXPECT_EQ(scale.scale(), settled) << whole_frame_s;
    }
    if (whole_frame_s < kTarget_s * 0.7) {
      EXPECT_EQ(settled, 1);
    }
  }
}

TEST(Screen, DrawsAtTheResolutionScale) {
  platform::headless::HeadlessWindow window({.size = {640, 400}});
  Screen screen;
  const ScreenSettings settings{.scale = 0.75f};
  EXPECT_EQ(screen.begin(window.size(), settings).width(), 480);
  ASSERT_TRUE(screen.show({}, {}, window).ok());
  EXPECT_EQ(window.shown_size(), (platform::PixelSize{480, 300}));
}

TEST(FrameLimiter, HoldsTheRate) {
  FrameLimiter limiter;
  const auto now_s = [] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  };
  limiter.wait(200, now_s);
  const double began_s = now_s();
  for (int i = 0; i < 20; ++i) limiter.wait(200, now_s);
  // Never faster than the limit. How much slower depends on the machine.
  EXPECT_GE(now_s() - began_s, 19.0 / 200);
}

TEST(Threads, WorkerRunsOneJobAtATime) {
  Worker worker;
  int done = 0;
  for (int i = 0; i < 1000; ++i) {
    worker.begin([&] { ++done; });
    worker.wait();
    ASSERT_EQ(done, i + 1);
  }
  worker.wait();
}

}  // namespace
}  // namespace temblor::host
