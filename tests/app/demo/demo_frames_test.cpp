// Frames of stock demos have the same pixels for any number of threads, in every run, and when the demo is
// transcoded to another protocol.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/demo/demo_run.h"
#include "support/effort.h"
#include "support/game_data.h"
#include "support/pictures/frames.h"
#include "support/programs/transcode.h"

namespace temblor::app {
namespace {

constexpr int kEvery = 50;  // frames

LoadedDemo load_stock(const std::filesystem::path& data, const std::string& name) {
  return load_demo({.base_folder = data.string(), .games = {}}, name).value();
}

// Returns hashes of every 50th frame, played packet by packet.
std::vector<std::uint64_t> frame_hashes(const LoadedDemo& demo, render::PixelFormat format, int threads) {
  render::Settings settings;
  settings.threads = threads;
  settings.job_backend = base::JobBackend::kStdThread;  // uses exactly this many threads
  const FrameOptions frame{.size = {320, 200}, .format = format, .threads = {}};
  DemoRun run = DemoRun::start(demo, frame, {}, settings).value();
  std::vector<std::uint64_t> hashes;
  for (int number = 0;; ++number) {
    if (number % kEvery == 0) {
      EXPECT_TRUE(run.draw().ok());
      hashes.push_back(test::compute_hash(run.frame()));
    }
    const base::Result<bool> has_more = run.advance_by_packet();
    EXPECT_TRUE(has_more.ok()) << has_more.error().message();
    if (!has_more.ok() || !*has_more) return hashes;
  }
}

class StockDemoFrames : public ::testing::TestWithParam<const char*> {};

TEST_P(StockDemoFrames, DoNotDependOnThreadsOrRuns) {
  DATA_FOLDER_OR_SKIP(data);
  const LoadedDemo demo = load_stock(data, GetParam());
  const bool under_sanitizer = test::effort(0, 1) == 1;
  std::vector<render::PixelFormat> formats = {render::PixelFormat::kRgb};
  if (!under_sanitizer) formats.push_back(render::PixelFormat::kIndexed);
  for (const render::PixelFormat format : formats) {
    const std::vector<std::uint64_t> one = frame_hashes(demo, format, 1);
    EXPECT_GT(one.size(), 20u);
    EXPECT_EQ(frame_hashes(demo, format, 8), one);
    if (under_sanitizer) continue;
    EXPECT_EQ(frame_hashes(demo, format, 1), one);
    EXPECT_EQ(frame_hashes(demo, format, 2), one);
  }
}

// Protocol 666 encodes positions and angles like protocol 15, so the frames are the same.
TEST(DemoFrames, DoNotChangeInProtocol666) {
  DATA_FOLDER_OR_SKIP(data);
  const LoadedDemo demo = load_stock(data, "demo1_lite");
  LoadedDemo again{demo.name, test::transcode(demo.bytes, {net::Protocol::kFitzQuake, 0}).value(),
                   demo.library, demo.look};
  EXPECT_EQ(frame_hashes(again, render::PixelFormat::kRgb, 2),
            frame_hashes(demo, render::PixelFormat::kRgb, 2));
}

INSTANTIATE_TEST_SUITE_P(Demos, StockDemoFrames,
                         ::testing::Values("demo1_lite", "demo2_lite", "demo3_lite", "demo3"),
                         [](const auto& demo) { return std::string(demo.param); });

}  // namespace
}  // namespace temblor::app
