// `temblor lab card`: a table, JSON, a machine without OpenGL, and mistakes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/program.h"
#include "platform/egl/offscreen_context.h"
#include "support/effort.h"
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

TEST(CardProgram, MeasuresEveryCacheAndMethod) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL";
  Words words{"--json", "--size", "160x120"};
  if (!kQuick) words.insert(words.end(), {"--size", "320x200"});
  const ProgramRun program = run_card(words);
  ASSERT_EQ(program.exit_status, 0) << program.err;
  const json result = json::parse(program.out);
  EXPECT_NE(result.at("driver"), "");
  EXPECT_EQ(result.at("lights"), 0);
  const json& runs = result.at("runs");
  constexpr std::array kMethods = {"8 bit expanded", "card's blocks", "lit textures", "light pass",
                                   "light polygons", "vertex light",  "style layers"};
  constexpr std::size_t kCaches = 12, kRuns = kCaches + kMethods.size();  // at each size
  ASSERT_EQ(runs.size(), (kQuick ? 1 : 2) * kRuns);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const json& run = runs[i];
    const std::size_t number = i % kRuns;
    ASSERT_FALSE(run.contains("problem")) << run;
    EXPECT_EQ(run.at("size"), i < kRuns ? "160x120" : "320x200");
    EXPECT_EQ(run.at("method"), number < kCaches ? "blocks" : kMethods[number - kCaches]);
    EXPECT_EQ(run.at("bits"), number < kCaches ? (std::array{32, 16, 8})[number / 4] : 32);
    EXPECT_EQ(run.at("megabytes"), number < kCaches ? (std::array{2, 4, 64, 256})[number % 4] : 64);
    const int cache_bytes = run.at("megabytes").get<int>() << 20;
    if (number < kCaches) {
      EXPECT_EQ(run.at("cache_bytes"), cache_bytes);
    } else {
      EXPECT_GT(run.at("cache_bytes"), cache_bytes) << "textures and light";
    }
    EXPECT_EQ(run.at("frames"), runs[i / kRuns * kRuns].at("frames"));
    EXPECT_GT(run.at("frame_ms").at("p50"), 0.0);
    EXPECT_GE(run.at("frame_ms").at("max"), run.at("frame_ms").at("p99"));
    EXPECT_GE(run.at("portions"), 1.0);
    if (run.at("method") != "style layers") {  // whose light is there since the first frame
      EXPECT_GT(run.at("hits").get<double>() + run.at("uploads").get<double>(), 0.0);
    }
    EXPECT_GE(run.at("max_bytes_uploaded"), run.at("bytes_uploaded"));
    const bool is_exact =
        run.at("bits") != 16 && run.at("method") != "vertex light" && run.at("method") != "8 bit expanded";
    if (is_exact) {
      EXPECT_GE(run.at("equal_share"), 0.95);
    }
  }
}

TEST(CardProgram, PrintsATable) {
  if (!has_opengl()) GTEST_SKIP() << "no OpenGL";
  const ProgramRun run = run_card({"--size", "160x120", "--lights", "3"});
  ASSERT_EQ(run.exit_status, 0) << run.err;
  for (const char* text : {"\nwith 3 lights around the eye\n", "\n160x120, ", "\n  2 MB, 32 bit ",
                           "\n  256 MB, 16 bit ", "\n  4 MB, 8 bit ", "\n  style layers "})
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
  EXPECT_EQ(run_card({"--lights", "-1"}).exit_status, 2);
  EXPECT_EQ(run_card({"--map", "no_such_level"}).exit_status, 1);
}

}  // namespace
}  // namespace temblor::test
