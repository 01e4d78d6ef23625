// `temblor lab card`: a table, JSON, a machine without OpenGL, and mistakes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "platform/egl/offscreen_context.h"
#include "support/programs/temporary_folder.h"

namespace temblor::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using Words = std::vector<std::string>;

bool has_opengl() {
  return platform::egl::make_offscreen_context().ok();
}

ProgramRun run_card(const Words& words) {
  const TemporaryFolder folder;
  Words all{"lab", "card", "--seconds", "0.05"};
  all.insert(all.end(), words.begin(), words.end());
  return run_program(folder.path(), all);
}

TEST(CardProgram, MeasuresEveryCache) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL";
  const ProgramRun run = run_card({"--json", "--size", "160x120", "--size", "320x200"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  const json result = json::parse(run.out);
  EXPECT_NE(result.at("driver"), "");
  const json& caches = result.at("runs");
  ASSERT_EQ(caches.size(), 16u);
  for (std::size_t i = 0; i < caches.size(); ++i) {
    const json& cache = caches[i];
    ASSERT_FALSE(cache.contains("problem")) << cache;
    EXPECT_EQ(cache.at("size"), i < 8 ? "160x120" : "320x200");
    EXPECT_EQ(cache.at("bits"), i / 4 % 2 == 0 ? 32 : 16);
    EXPECT_EQ(cache.at("megabytes"), (std::array{2, 4, 64, 256})[i % 4]);
    EXPECT_EQ(cache.at("cache_bytes"), cache.at("megabytes").get<int>() << 20);
    EXPECT_EQ(cache.at("frames"), caches[i / 8 * 8].at("frames"));
    EXPECT_GT(cache.at("frame_ms").at("p50"), 0.0);
    EXPECT_GE(cache.at("frame_ms").at("max"), cache.at("frame_ms").at("p99"));
    EXPECT_GE(cache.at("portions"), 1.0);
    EXPECT_GT(cache.at("hits").get<double>() + cache.at("uploads").get<double>(), 0.0);
    EXPECT_GE(cache.at("max_bytes_uploaded"), cache.at("bytes_uploaded"));
    if (cache.at("bits") == 32) EXPECT_GE(cache.at("equal_share"), 0.95);
  }
}

TEST(CardProgram, PrintsATable) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL";
  const ProgramRun run = run_card({"--size", "160x120"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  for (const char* text : {"\n160x120, ", "\n  2 MB, 32 bit ", "\n  256 MB, 16 bit "})
    EXPECT_THAT(run.out, HasSubstr(text));
}

TEST(CardProgram, SaysThatThereIsNoOpenGl) {
  // Neither GLVND nor Mesa finds a driver.
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", 1);
  const ProgramRun run = run_card({});
  unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
  if (run.exit_status == 0) GTEST_SKIP() << "OpenGL does not come from GLVND";
  EXPECT_EQ(run.exit_status, 1);
  EXPECT_TRUE(is_one_error_line(run.err)) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST(CardProgram, RefusesMistakes) {
  EXPECT_THAT(run_card({"--map", "x", "--demo", "y"}).err, HasSubstr("--demo"));
  EXPECT_EQ(run_card({"--map", "x", "--demo", "y"}).exit_status, 2);
  EXPECT_EQ(run_card({"--seconds", "0"}).exit_status, 2);
  EXPECT_EQ(run_card({"--map", "no_such_level"}).exit_status, 1);
}

}  // namespace
}  // namespace temblor::test
