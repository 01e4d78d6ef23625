// The output of `temblor bench` is complete and consistent.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/program.h"
#include "platform/egl/offscreen_context.h"
#include "render/frame_buffer.h"
#include "render/frame_stats.h"
#include "support/programs/small_game.h"

namespace temblor::test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Words = std::vector<std::string>;

json bench(const std::filesystem::path& folder, const Words& more) {
  Words words = {"bench", "--json", "--size", "64x48", "--step", "90"};
  words.insert(words.end(), more.begin(), more.end());
  const ProgramRun run = run_program(folder, words);
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.err, IsEmpty());
  return json::parse(run.out);
}

TEST(BenchProgram, ReportsAllMeasurements) {
  const TemporaryFolder folder;
  const json result = bench(folder.path(), {"--color", "indexed", "--threads", "2"});
  EXPECT_EQ(result.at("size"), "64x48");
  EXPECT_EQ(result.at("color"), "indexed");
  EXPECT_EQ(result.at("threads"), 2);
  EXPECT_GT(result.at("places"), 0);
  EXPECT_EQ(result.at("frames"), 4 * result.at("places").get<int>());
  EXPECT_GT(result.at("floor_ms"), 0.0);
  for (const char* name : {"frame_ms", "render_ms", "present_ms"}) {
    const json& times = result.at(name);
    EXPECT_GT(times.at("p50"), 0.0) << name;
    EXPECT_LE(times.at("p50"), times.at("p99")) << name;
    EXPECT_LE(times.at("p99"), times.at("max")) << name;
  }
  EXPECT_GE(result.at("frame_ms").at("p50"), result.at("render_ms").at("p50"));
  EXPECT_NEAR(result.at("render_floors"),
              result.at("render_ms").at("p50").get<double>() / result.at("floor_ms").get<double>(), 1e-9);
  for (const char* stage : render::kStageNames) EXPECT_TRUE(result.at("stages").contains(stage)) << stage;
  EXPECT_GT(result.at("stages").at("present"), 0.0);
  EXPECT_GE(result.at("faces").at("in_pvs"), result.at("faces").at("seen"));
  EXPECT_GT(result.at("cache_bytes"), 0);
  EXPECT_FALSE(result.contains("cold_ms"));
}

TEST(BenchProgram, WarmFramesBuildNothingAndAllocateNothing) {
  const TemporaryFolder folder;
  for (const char* color : {"indexed", "rgb"}) {
    const json result = bench(folder.path(), {"--color", color, "--threads", "1"});
    EXPECT_EQ(result.at("surfaces_built"), 0) << color;
    EXPECT_EQ(result.at("allocations"), 0) << color;
    EXPECT_EQ(result.at("allocating_frames"), 0) << color;
  }
}

TEST(BenchProgram, MeasuresLevelsThroughOpenGl) {
  const TemporaryFolder folder;
  for (const char* only_cpu : {"--cold", "--report", "--views=2"}) {
    const ProgramRun refused = run_program(folder.path(), {"bench", "--renderer", "gl", only_cpu});
    EXPECT_EQ(refused.exit_status, 2);
    EXPECT_THAT(refused.err, HasSubstr("--renderer gl: --cold, --report, and --views"));
  }
  if (!platform::egl::make_offscreen_context().ok()) GTEST_SKIP() << "no OpenGL";
  for (const char* color : {"indexed", "rgb"}) {
    const json result = bench(folder.path(), {"--color", color, "--renderer", "gl"});
    EXPECT_EQ(result.at("frames"), 4 * result.at("places").get<int>());
    EXPECT_GT(result.at("frame_ms").at("p50"), 0.0);
    EXPECT_EQ(result.at("surfaces_built"), 0) << color;
  }
}

TEST(BenchProgram, SettingsReachTheRenderer) {
  const TemporaryFolder folder;
  EXPECT_GT(bench(folder.path(), {"--set", "r_surface_cache=0"}).at("surfaces_built"), 0);
}

TEST(BenchProgram, ColdViewsOnRequest) {
  const TemporaryFolder folder;
  const json result = bench(folder.path(), {"--cold"});
  EXPECT_GT(result.at("cold_ms").at("p50"), 0.0);
  EXPECT_LE(result.at("circle_cache_bytes").at("max"), result.at("cache_bytes"))
      << "all places together need at least as much as one";
}

TEST(BenchProgram, SeveralLevelsGiveAList) {
  const SmallGame game;
  const json results = bench(game.path(), {"--map", "small", "--map", "small"});
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].at("map"), "small");
}

TEST(BenchProgram, MeasuresEachLevelAtAllSizes) {
  const SmallGame game;
  const json results = bench(game.path(), {"--map", "small", "--size", "32x16", "--map", "small"});
  std::vector<std::string> sizes;
  for (const json& result : results) sizes.push_back(result.at("size"));
  EXPECT_THAT(sizes, ElementsAre("64x48", "32x16", "64x48", "32x16"));
}

TEST(BenchProgram, RejectsBadSizes) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(folder.path(), {"bench", "--size", "64x48", "--size", "64x0"});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_THAT(run.err, HasSubstr("--size: \"64x0\" is not WIDTHxHEIGHT"));
}

TEST(BenchProgram, PrintsText) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(folder.path(), {"bench", "--size", "64x48", "--step", "180", "--cold"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  for (const char* word : {"fps", "median", "fill baselines", "cold cache", "spans", "cycles/pixel",
                           "overlay", "frames allocate"})
    EXPECT_THAT(run.out, HasSubstr(word));
}

TEST(BenchProgram, DrawsViewsAtOnce) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(folder.path(), {"bench", "--json", "--views", "3", "--size", "32x24",
                                                     "--size", "64x48", "--threads", "2"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  const json results = json::parse(run.out);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].at("size"), "32x24");
  EXPECT_EQ(results[1].at("size"), "64x48");
  for (const json& result : results) {
    EXPECT_EQ(result.at("views"), 3);
    EXPECT_EQ(result.at("threads"), 2);
    EXPECT_GT(result.at("at_once_ms").at("p50"), 0.0);
    EXPECT_NEAR(
        result.at("ratio"),
        result.at("at_once_ms").at("p50").get<double>() / result.at("one_by_one_ms").at("p50").get<double>(),
        1e-9);
  }
}

TEST(BenchProgram, DrawsSmallViewsByDefault) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(folder.path(), {"bench", "--views", "1"});
  EXPECT_EQ(run.exit_status, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr(": 1 view, 160x120 rgb"));
}

TEST(BenchProgram, RefusesViewsThatNeedTooMuchMemory) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(folder.path(), {"bench", "--views", "64", "--size", "8192x8192"});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_THAT(run.err, HasSubstr("64 views of 8192x8192 have 4294967296 pixels; the limit is 134217728"));
}

TEST(BenchProgram, RefusesViewsOfADemo) {
  const TemporaryFolder folder;
  const ProgramRun run = run_program(folder.path(), {"bench", "--views", "2", "--demo", "demo1"});
  EXPECT_EQ(run.exit_status, 2);
  EXPECT_THAT(run.err, HasSubstr("--views"));
}

}  // namespace
}  // namespace temblor::test
